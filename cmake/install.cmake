# What is installed, by `cmake --install` and in packages: the program, the page that web/build.mjs made, the examples with their pictures,
# and what the program writes about itself. The program finds all of it beside its own folder, wherever that is.
include(GNUInstallDirs)
set(dini_share ${CMAKE_INSTALL_DATAROOTDIR}/dini)

install(TARGETS dini RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY web/dist/ DESTINATION ${dini_share}/web)
install(DIRECTORY examples/ DESTINATION ${dini_share}/examples)
install(DIRECTORY docs/images/examples/ DESTINATION ${dini_share}/examples/images)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# install_words(FILE WORD...): installs what the program prints when it is given these words.
function(install_words file)
  list(JOIN ARGN "\" \"" words)
  install(CODE "
    set(target \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATAROOTDIR}/${file}\")
    message(STATUS \"Installing: \${target}\")
    cmake_path(GET target PARENT_PATH folder)
    file(MAKE_DIRECTORY \"\${folder}\")
    execute_process(COMMAND \"$<TARGET_FILE:dini>\" \"${words}\" OUTPUT_FILE \"\${target}\" COMMAND_ERROR_IS_FATAL ANY)")
endfunction()
install_words(bash-completion/completions/dini completion bash)
install_words(zsh/vendor-completions/_dini completion zsh)
install_words(fish/vendor_completions.d/dini.fish completion fish)
install_words(man/man1/dini.1 describe --manual)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The Dini contributors <dini@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Graphs of geometry nodes, evaluated into Draco-compressed glTF")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
