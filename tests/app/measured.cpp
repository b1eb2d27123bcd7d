#include <cstdio>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// Runs a command and writes its CPU time in milliseconds and its peak memory in kilobytes to
// descriptor 9. Usage: measured COMMAND... Exit code: the command's; 128 and more if a signal ended
// it.

int main(int count, char** words) {
  if (count < 2) return 2;
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(9);
    ::execvp(words[1], words + 1);
    ::_exit(127);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return 2;
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto ms = [](const timeval& time) { return time.tv_sec * 1000 + time.tv_usec / 1000; };
  ::dprintf(9, "%ld %ld\n", ms(used.ru_utime) + ms(used.ru_stime), used.ru_maxrss);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
