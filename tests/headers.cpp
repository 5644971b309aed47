// Empty: the target dini_test_headers exists for its precompiled headers.
