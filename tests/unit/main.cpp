// SPDX-License-Identifier: MIT
// The test runner; the tests are in the files beside it, one per source file.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
