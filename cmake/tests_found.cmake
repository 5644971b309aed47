# Fails when a test program has been asked for its tests and named none. Catch takes that for a program without tests, and goes on:
# a program that could not be started would be left out of ctest without a word.
#
#   cmake -DLISTS=FOLDER/tests_NAME_tests -P tests_found.cmake
file(GLOB lists "${LISTS}-*.cmake")
if(NOT lists)
  message(FATAL_ERROR "There is no list of tests at ${LISTS}-*.cmake")
endif()
foreach(list IN LISTS lists)
  file(STRINGS "${list}" tests REGEX "^add_test")
  if(NOT tests)
    file(REMOVE "${list}")
    message(FATAL_ERROR "The test program named no tests for ${list}; it may not have started")
  endif()
endforeach()
