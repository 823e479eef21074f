// SPDX-License-Identifier: MIT
// The JSON library, as all of our files see it: it spells characters by their numbers with
// snprintf, which brings along all that printf can print, an eightieth of our module.
#pragma once

#include <string>
#include <string_view>

// What the library calls std: the same, but for that function.
namespace nlohmann::std {

using namespace ::std;

// %x and %X as four digits, or as two after `hh`: what the library writes of integers. Floating
// point numbers it writes by itself, unless they are none of IEEE's.
template <class... Parts>
int snprintf(char* out, size_t size, string_view format, Parts... parts) {
  const unsigned values[] = {static_cast<unsigned>(parts)...};
  string text;
  for (size_t i = 0, next = 0; i < format.size(); ++i) {
    if (format[i] != '%') {
      text += format[i];
      continue;
    }
    const size_t end = format.find_first_of("xXg", i);
    const bool isShort = format.substr(i, end - i).find("hh") != string_view::npos;
    const char* const digits = format[end] == 'x' ? "0123456789abcdef" : "0123456789ABCDEF";
    for (int shift = isShort ? 4 : 12; shift >= 0; shift -= 4)
      text += digits[values[next] >> shift & 15];
    ++next;
    i = end;
  }
  const size_t count = text.copy(out, size - 1);
  out[count] = 0;
  return static_cast<int>(text.size());
}

}  // namespace nlohmann::std

#include <nlohmann/json.hpp>
