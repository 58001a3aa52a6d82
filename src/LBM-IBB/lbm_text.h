// SPDX-License-Identifier: GPL-2.0-only
// Text as printf writes it, as a string.

#ifndef LBM_TEXT_H
#define LBM_TEXT_H

#include <cstdarg>
#include <cstdio>
#include <string>

namespace lbm {

__attribute__((format(printf, 1, 2))) inline std::string print(const char *format, ...)
{
  char text[512];
  va_list args;
  va_start(args, format);
  std::vsnprintf(text, sizeof text, format, args);
  va_end(args);
  return text;
}

}    // namespace lbm
#endif
