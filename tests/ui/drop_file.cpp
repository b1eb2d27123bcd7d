// Drops a file on a window like a file manager, by the XDND protocol, version 5
// (https://freedesktop.org/wiki/Specifications/XDND), for the tests of the real window.
//
//   drop_file WINDOW-ID FILE
//
// Exit codes: 0 the window took it, 1 it did not within five seconds, 2 bad arguments.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

namespace {

class Source {
 public:
  Source(Display* display, Window target, std::string uri)
      : display_(display),
        target_(target),
        window_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)),
        uri_(std::move(uri)) {}

  /// Announces the data, moves over the window and drops; returns whether the file was taken.
  bool drop() {
    XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
    send("XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, (200L << 16) | 200L, CurrentTime,
         static_cast<long>(atom("XdndActionCopy")));
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(5)) {
      if (XPending(display_) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        continue;
      }
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == SelectionRequest) answer(event.xselectionrequest);
      if (event.type != ClientMessage) continue;
      const Atom type = event.xclient.message_type;
      if (type == atom("XdndStatus")) {
        if ((event.xclient.data.l[1] & 1) == 0) return false;
        send("XdndDrop", 0, CurrentTime, 0, 0);
      }
      if (type == atom("XdndFinished")) return true;
    }
    return false;
  }

 private:
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  void send(const char* message, long a, long b, long c, long d) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    const long data[5] = {static_cast<long>(window_), a, b, c, d};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  void answer(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(uri_.data()),
                    static_cast<int>(uri_.size()));
    XEvent reply{};
    reply.xselection.type = SelectionNotify;
    reply.xselection.requestor = request.requestor;
    reply.xselection.selection = request.selection;
    reply.xselection.target = request.target;
    reply.xselection.property = request.property;
    reply.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &reply);
    XFlush(display_);
  }

  Display* display_;
  Window target_;
  Window window_;
  std::string uri_;
};

/// A path as a URI (RFC 3986): everything but unreserved characters is percent-encoded.
std::string uri_of(const std::string& path) {
  std::string uri = "file://";
  for (const char c : path) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       std::strchr("/-._~", c) != nullptr;
    char escaped[4];
    std::snprintf(escaped, sizeof escaped, "%%%02X", static_cast<unsigned char>(c));
    uri += plain ? std::string(1, c) : escaped;
  }
  return uri;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: drop_file WINDOW-ID FILE\n", stderr);
    return 2;
  }
  Display* display = XOpenDisplay(nullptr);
  if (!display) return 2;
  const Window target = std::strtoul(argv[1], nullptr, 0);
  const std::string path = std::filesystem::absolute(argv[2]).string();
  const bool taken = Source(display, target, uri_of(path) + "\r\n").drop();
  XCloseDisplay(display);
  return taken ? 0 : 1;
}
