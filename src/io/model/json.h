// SPDX-License-Identifier: MIT
// The JSON library as all our files include it. It writes characters by number with snprintf, which
// links in all of printf, an eightieth of our module.
#pragma once

#include <string>
#include <string_view>

// Replaces std inside the library: the same, except for snprintf.
namespace nlohmann::std {

using namespace ::std;

// Supports %x and %X as four digits, or as two after `hh`, which the library uses for integers. The
// library writes IEEE floating point numbers by itself.
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
