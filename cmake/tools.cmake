# Tools that make building quicker and change nothing else; each is used where it is installed.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(DINI_CCACHE ccache)
  if(DINI_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${DINI_CCACHE})
  endif()
endif()
find_program(DINI_MOLD mold)
if(DINI_MOLD)
  # Code on pages of its own, as the usual linker has it: mold 1.10 may otherwise let the part that is read-only after relocation begin
  # in the last bytes of a page that is not mapped, and the program does not start.
  add_link_options(-fuse-ld=mold -Wl,-z,separate-code)
endif()
