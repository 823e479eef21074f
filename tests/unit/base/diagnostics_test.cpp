// SPDX-License-Identifier: MIT
#include "base/diagnostics.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace remesher;

TEST_CASE("diagnostics: rows are sorted by their codes, each code once") {
  const auto rows = diagnostics();
  CHECK(std::is_sorted(rows.begin(), rows.end(),
                       [](const Diagnostic& a, const Diagnostic& b) { return a.code < b.code; }));
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i - 1].code != rows[i].code);
}

TEST_CASE("diagnostics: each row is found by its code") {
  for (const Diagnostic& row : diagnostics())
    CHECK(severityOf({std::string(row.code), "", 1}) == row.severity);
  CHECK(severityOf({"NO_SUCH_CODE", "", 1}) == Severity::Loss);
}
