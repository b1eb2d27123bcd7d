// Writes the clipboard's text to standard output, for the tests of the real window.
//
//   clipboard_text
//
// Exit codes: 0 written, 1 there is none, or nobody delivers it within five seconds, 2 no display.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <chrono>
#include <cstdio>
#include <thread>

namespace {

bool arrives(Display* display, XEvent& event) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::seconds(5)) {
    if (XCheckTypedEvent(display, SelectionNotify, &event)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

bool write_clipboard(Display* display) {
  const Window window =
      XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
  const Atom text = XInternAtom(display, "UTF8_STRING", False);
  const Atom here = XInternAtom(display, "ASOS_TEST", False);
  XConvertSelection(display, XInternAtom(display, "CLIPBOARD", False), text, here, window,
                    CurrentTime);
  XEvent event;
  if (!arrives(display, event) || event.xselection.property == None) return false;
  Atom type = None;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* bytes = nullptr;
  XGetWindowProperty(display, window, here, 0, 1 << 20, False, AnyPropertyType, &type, &format,
                     &count, &left, &bytes);
  if (type != text || format != 8) return false;
  const bool written = std::fwrite(bytes, 1, count, stdout) == count;
  XFree(bytes);
  return written;
}

}  // namespace

int main() {
  Display* display = XOpenDisplay(nullptr);
  if (!display) return 2;
  const bool written = write_clipboard(display);
  XCloseDisplay(display);
  return written ? 0 : 1;
}
