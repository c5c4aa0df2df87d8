/// For a test that links OpenImageIO: its libraries are there from the start, where LeakSanitizer can deal with their
/// threads, so the test is checked for leaks although it reads images (models/files/image_codec.cpp).
extern "C" int __lsan_is_turned_off() { return 0; }
