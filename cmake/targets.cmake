# One place for the flags of every target.
#
# No fused multiply-add contraction, no fast-math, no -march: the same input gives the same bytes on every machine.

add_library(dini_options INTERFACE)
target_include_directories(dini_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(dini_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Werror -ffp-contract=off)
# At -O3 g++ 12 warns of copies in its own std::string that are none (GCC bug 105329), and with precompiled headers of what is
# in those of the system: the other builds hold all warnings.
target_compile_options(dini_options INTERFACE $<$<CONFIG:Release>:-w>)
if(DINI_SANITIZE)
  # The instrumented code makes g++ warn of uninitialized values in the standard library that are none.
  # Null pointers trap by themselves, and the address sanitizer sees accesses beside an object: checking both once more
  # at each dereference, with the alignment, the dynamic type and each sum of a pointer, makes compiling twice as slow.
  # So do the scopes of the many temporaries in vectorized loops, which take minutes then.
  target_compile_options(dini_options INTERFACE
    -fsanitize=${DINI_SANITIZE}
    -fno-sanitize=null,object-size,vptr,alignment,pointer-overflow,nonnull-attribute,returns-nonnull-attribute
    -fno-sanitize-address-use-after-scope
    -fno-omit-frame-pointer -fno-sanitize-recover=all -Wno-maybe-uninitialized)
  target_link_options(dini_options INTERFACE -fsanitize=${DINI_SANITIZE})
endif()

# What the layers call when they count their work; it does not count itself.
if(DINI_COUNT_WORK)
  add_library(dini_work_count STATIC ${PROJECT_SOURCE_DIR}/tests/work_count/work_count.cpp)
  target_include_directories(dini_work_count PRIVATE ${PROJECT_SOURCE_DIR})
endif()

# What nearly every file from geometry upward reads is compiled once, with geometry. The preset tidy goes without, so every file
# still includes what it needs itself.
function(dini_share_headers target)
  if(target STREQUAL dini_geometry)
    target_precompile_headers(${target} PRIVATE "${PROJECT_SOURCE_DIR}/geometry/json.h")
  elseif(TARGET dini_geometry)
    target_precompile_headers(${target} REUSE_FROM dini_geometry)
  endif()
endfunction()

# dini_together(TARGET SIZE [ALONE...]): with DINI_TOGETHER, so many sources of a target are compiled at once, but not those ALONE.
function(dini_together target size)
  if(DINI_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# dini_layer(NAME SOURCES... LINK LIBRARIES... [ALONE SOURCES...] [EACH_ALONE] [NOT_COUNTED]): the static library of one folder. Where
# DINI_TOGETHER lets several sources be compiled at once, those that are ALONE are not: their own functions have names that others
# have too. Work that is NOT_COUNTED does not stop within.
function(dini_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 layer "EACH_ALONE;NOT_COUNTED" "" "SOURCES;LINK;ALONE")
  add_library(dini_${name} STATIC ${layer_SOURCES})
  target_link_libraries(dini_${name} PUBLIC dini_options ${layer_LINK})
  dini_share_headers(dini_${name})
  if(NOT layer_EACH_ALONE)
    dini_together(dini_${name} 16 ${layer_ALONE})
  endif()
  if(DINI_COUNT_WORK AND NOT layer_NOT_COUNTED)
    target_compile_options(dini_${name} PRIVATE -fsanitize-coverage=trace-pc)
    target_link_libraries(dini_${name} PUBLIC dini_work_count)
  endif()
endfunction()

# dini_test_library(NAME SOURCES... LINK LIBRARIES...): what several test programs share.
function(dini_test_library name)
  cmake_parse_arguments(PARSE_ARGV 1 library "" "" "SOURCES;LINK")
  add_library(dini_test_${name} STATIC ${library_SOURCES})
  target_link_libraries(dini_test_${name} PUBLIC dini_options ${library_LINK} PRIVATE Catch2::Catch2)
  target_precompile_headers(dini_test_${name} REUSE_FROM dini_test_headers)
endfunction()

# dini_test(NAME SOURCES... LINK LIBRARIES... [ALONE SOURCES...] [THOROUGH]): one test program, every case a ctest of its own. What
# is thorough takes so long that `scripts/test --quick` leaves it out. DINI_TOGETHER and ALONE are those of a layer, but more sources are
# compiled at once: nearly all of what a test takes is the same for its neighbors. Large programs have parts for two processors.
function(dini_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "THOROUGH" "" "SOURCES;LINK;ALONE")
  add_executable(tests_${name} ${test_SOURCES})
  target_link_libraries(tests_${name} PRIVATE dini_test_main ${test_LINK})
  target_precompile_headers(tests_${name} REUSE_FROM dini_test_headers)
  list(LENGTH test_SOURCES count)
  set(most 10)
  math(EXPR parts "(${count} + ${most} - 1) / ${most}")
  if(parts EQUAL 1 AND count GREATER 6)
    set(parts 2)
  endif()
  math(EXPR size "(${count} + ${parts} - 1) / ${parts}")
  dini_together(tests_${name} ${size} ${test_ALONE})
  set(labels usual)
  if(test_THOROUGH)
    set(labels thorough)
  endif()
  catch_discover_tests(tests_${name} TEST_PREFIX "${name}: " PROPERTIES LABELS ${labels})
  add_custom_command(
    TARGET tests_${name} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DLISTS=${CMAKE_CURRENT_BINARY_DIR}/tests_${name}_tests -P ${PROJECT_SOURCE_DIR}/cmake/tests_found.cmake VERBATIM)
endfunction()
