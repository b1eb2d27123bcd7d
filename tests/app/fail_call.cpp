#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// Makes one system call of a program fail, whichever library makes it, like a full or broken disk.
// Usage: fail_call N FAULT FOLDER COMMAND... Counts the calls that create, write, close and rename
// files in FOLDER. The N-th one fails with FAULT: ENOSPC, EIO, or "short", which writes half of the
// bytes and fails all later writes. N 0: no call fails. Writes a line per call to descriptor 9.
// Exit code: the command's; 77 if the system does not allow this; 128 and more if a signal ended
// the command.

namespace {

constexpr int report = 9;

struct Plan {
  unsigned long failing = 0;
  int error = ENOSPC;
  bool half = false;
  std::string folder;
};

constexpr int watched[] = {SYS_openat,   SYS_write, SYS_pwrite64,  SYS_writev,
                           SYS_close,    SYS_fsync, SYS_fdatasync, SYS_ftruncate,
#ifdef SYS_open
                           SYS_open,
#endif
#ifdef SYS_rename
                           SYS_rename,
#endif
#ifdef SYS_renameat
                           SYS_renameat,
#endif
                           SYS_renameat2};

/// Makes the kernel notify about the watched calls. Returns the descriptor of the notifications, or
/// -1.
int install_filter() {
  std::vector<sock_filter> filter{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const int call : watched) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
  }
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return -1;
  return static_cast<int>(
      ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program));
}

union Control {
  cmsghdr header;
  char bytes[CMSG_SPACE(sizeof(int))];
};

void send_descriptor(int socket, int descriptor) {
  char byte = 0;
  iovec data{&byte, 1};
  Control control{};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = control.bytes;
    message.msg_controllen = sizeof control.bytes;
    control.header = {CMSG_LEN(sizeof descriptor), SOL_SOCKET, SCM_RIGHTS};
    std::memcpy(CMSG_DATA(&control.header), &descriptor, sizeof descriptor);
  }
  ::sendmsg(socket, &message, 0);
}

int receive_descriptor(int socket) {
  char byte = 0;
  iovec data{&byte, 1};
  Control control{};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control.bytes;
  message.msg_controllen = sizeof control.bytes;
  if (::recvmsg(socket, &message, 0) <= 0 || !CMSG_FIRSTHDR(&message)) return -1;
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof descriptor);
  return descriptor;
}

std::string link_of(const std::string& link) {
  char name[4096];
  const ssize_t length = ::readlink(link.c_str(), name, sizeof name);
  return {name, length > 0 ? static_cast<std::size_t>(length) : 0};
}

/// Resolves a path that a process passes, relative to its current folder.
std::string path_at(pid_t process, std::uint64_t address) {
  char name[4096] = {};
  iovec here{name, sizeof name - 1};
  iovec there{reinterpret_cast<void*>(address), sizeof name - 1};
  ssize_t got = ::process_vm_readv(process, &here, 1, &there, 1, 0);
  if (got <= 0) {  // fewer than 4096 bytes may be readable
    here.iov_len = there.iov_len = 4096 - address % 4096;
    got = ::process_vm_readv(process, &here, 1, &there, 1, 0);
  }
  const std::string path = got > 0 ? name : "";
  return path.starts_with('/') ? path
                               : link_of("/proc/" + std::to_string(process) + "/cwd") + "/" + path;
}

/// Whether a descriptor of a process is open for writing.
bool is_written(pid_t process, std::uint64_t descriptor) {
  const std::string path =
      "/proc/" + std::to_string(process) + "/fdinfo/" + std::to_string(descriptor);
  std::ifstream info(path);
  for (std::string word; info >> word;)
    if (word == "flags:" && info >> word)
      return (std::strtoul(word.c_str(), nullptr, 8) & O_ACCMODE) != O_RDONLY;
  return false;
}

/// Describes a call and its file; "" if it writes none.
std::string described(const seccomp_notif& asked) {
  const auto process = static_cast<pid_t>(asked.pid);
  const auto& arguments = asked.data.args;
  const auto of_descriptor = [&](const char* what) {
    const std::string fd = std::to_string(process) + "/fd/" + std::to_string(arguments[0]);
    return std::string(what) + " " + link_of("/proc/" + fd);
  };
  const auto of_path = [&](const char* what, std::uint64_t address) {
    return std::string(what) + " " + path_at(process, address);
  };
  switch (asked.data.nr) {
    case SYS_openat:
      return (arguments[2] & O_CREAT) != 0 ? of_path("create", arguments[1]) : "";
#ifdef SYS_open
    case SYS_open:
      return (arguments[1] & O_CREAT) != 0 ? of_path("create", arguments[0]) : "";
#endif
#ifdef SYS_rename
    case SYS_rename:
      return of_path("rename", arguments[1]);
#endif
#ifdef SYS_renameat
    case SYS_renameat:
#endif
    case SYS_renameat2:
      return of_path("rename", arguments[3]);
    case SYS_close:
      return is_written(process, arguments[0]) ? of_descriptor("close") : "";
    case SYS_fsync:
    case SYS_fdatasync:
      return of_descriptor("sync");
    case SYS_ftruncate:
      return of_descriptor("truncate");
    default:
      return of_descriptor("write");
  }
}

/// Answers the kernel's notifications until the program has ended.
void answer(int listener, const Plan& plan) {
  unsigned long count = 0;
  for (;;) {
    pollfd waiting{listener, POLLIN, 0};
    if (::poll(&waiting, 1, -1) < 0 && errno == EINTR) continue;
    if ((waiting.revents & POLLIN) == 0) return;  // all watched processes have ended
    seccomp_notif asked{};
    if (::ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) {
      if (errno == EINTR || errno == ENOENT) continue;
      return;
    }
    seccomp_notif_resp told{};
    told.id = asked.id;
    told.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
    const std::string call = described(asked);
    if (call.find(" " + plan.folder + "/") != std::string::npos) {
      ++count;
      ::dprintf(report, "%s\n", call.c_str());
      const bool writes = call.starts_with("write ");
      if (plan.half && plan.failing != 0 && count >= plan.failing && writes) {
        told.flags = 0;
        if (count == plan.failing && asked.data.nr == SYS_write && asked.data.args[2] > 1) {
          told.val = static_cast<std::int64_t>(asked.data.args[2] / 2);
        } else {
          told.error = -ENOSPC;
        }
      } else if (!plan.half && count == plan.failing) {
        told.flags = 0;
        told.error = -plan.error;
      }
    }
    ::ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &told);
  }
}

}  // namespace

int main(int count, char** words) {
  if (count < 5) return 2;
  Plan plan;
  plan.failing = std::strtoul(words[1], nullptr, 10);
  const std::string_view fault = words[2];
  plan.half = fault == "short";
  plan.error = fault == "EIO" ? EIO : ENOSPC;
  plan.folder = words[3];
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) return 77;
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(report);
    send_descriptor(sockets[1], install_filter());
    ::execvp(words[4], words + 4);
    ::_exit(127);
  }
  ::close(sockets[1]);
  const int listener = receive_descriptor(sockets[0]);
  if (listener < 0) return 77;
  answer(listener, plan);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
