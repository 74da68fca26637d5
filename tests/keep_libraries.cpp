// Part of builds with AddressSanitizer: libraries stay loaded, so that its reports can name them.
extern "C" int dlclose(void*) {
  return 0;
}
