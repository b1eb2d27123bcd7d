#include "renderer/files/printable.h"

#include "renderer/result.h"

#include <gtest/gtest.h>

namespace asos::printable_test {
namespace {

TEST(Printable, EveryControlByteIsEscaped) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string shown = printable(std::string("a") + static_cast<char>(byte) + "b");
    const bool plain = byte >= 0x20 && byte < 0x7f;
    EXPECT_EQ(shown.size() == 3, plain) << byte << ": " << shown;
    for (const char c : shown) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << byte << ": " << shown;
  }
  EXPECT_EQ(printable("\x1b[31mred\a"), "\\x1b[31mred\\x07");
  EXPECT_EQ(printable("one\ntwo\r\tthree"), "one\\ntwo\\r\\tthree");
}

TEST(Printable, MarksThatDeceiveAreEscaped) {
  EXPECT_EQ(printable("\u202egnp.exe"), "\\u{202e}gnp.exe");
  for (const char* mark :
       {"\u0085", "\u009b", "\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202d",
        "\u2066", "\u2069", "\u200b", "\ufeff", "\U000e0041"})
    EXPECT_EQ(printable(mark).substr(0, 3), "\\u{") << mark;
}

TEST(Printable, OtherTextStays) {
  for (const char* text : {"", "plain", "C:\\models\\a.glb", "Größe 日本語 🚲", "שלום", "a\\x1bb"})
    EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable(printable("\x1b\xff\n")), printable("\x1b\xff\n"));
}

TEST(Printable, WhatIsNoUtf8IsEscapedByteByByte) {
  EXPECT_EQ(printable("a\xff"), "a\\xff");
  EXPECT_EQ(printable("\xc3"), "\\xc3");                    // cut off
  EXPECT_EQ(printable("\xc0\x8a"), "\\xc0\\x8a");           // a newline in an overlong encoding
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond the last code point
  EXPECT_EQ(printable("\xc3\xa4\xa4"), "ä\\xa4");
  EXPECT_TRUE(is_utf8("ä日🚲"));
  EXPECT_FALSE(is_utf8("ä\xa4"));
}

TEST(Printable, ErrorsAreOneLine) {
  const Error error{"a\nb.glb", "has \x1b[2J in it"};
  EXPECT_EQ(error.message(), "a\\nb.glb: has \\x1b[2J in it");
}

}  // namespace
}  // namespace asos::printable_test
