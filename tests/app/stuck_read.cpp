#include <string>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

// Preloaded, it makes a file whose name has "stuck" in it one that is never read to its end, as a
// decoder's endless loop would: see interrupt_test.sh.

extern "C" ssize_t read(int descriptor, void* bytes, size_t size) {
  char name[512];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = ::readlink(link.c_str(), name, sizeof name);
  const std::string path(name, length > 0 ? static_cast<std::size_t>(length) : 0);
  while (path.find("/stuck.") != std::string::npos) ::pause();
  return ::syscall(SYS_read, descriptor, bytes, size);
}
