// Stands before OpenSSL's function of the same name and changes one bit of every second digest.

#include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) int EVP_DigestFinal_ex(void* context,
                                                                         unsigned char* digest,
                                                                         unsigned int* size) {
  using Function = int (*)(void*, unsigned char*, unsigned int*);
  static const auto genuine = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "EVP_DigestFinal_ex"));
  static int calls = 0;
  const int result = genuine(context, digest, size);
  if (++calls % 2 == 0) digest[0] ^= 1U;
  return result;
}
