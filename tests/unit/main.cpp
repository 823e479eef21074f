// SPDX-License-Identifier: MIT
// The test runner; the tests are in the files beside it, one per source file. With `-r=fires` it
// prints which fallbacks and limits of work each test reaches: a line of JSON per test.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "base/fires.h"

namespace {

std::map<std::string, std::size_t>& counts() {
  static std::map<std::string, std::size_t> only;
  return only;
}

class FiresReporter : public doctest::IReporter {
 public:
  explicit FiresReporter(const doctest::ContextOptions& options) : out_(*options.cout) {}

  void test_case_start(const doctest::TestCaseData& test) override {
    name_ = test.m_name;
    counts().clear();
  }
  void test_case_end(const doctest::CurrentTestCaseStats&) override {
    if (counts().empty()) return;
    out_ << nlohmann::ordered_json({{"run", name_}, {"fired", counts()}}) << std::endl;
  }

  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}

 private:
  std::ostream& out_;
  std::string name_;
};

}  // namespace

REGISTER_REPORTER("fires", 1, FiresReporter);

void remesher::fires(std::string_view name) { ++counts()[std::string(name)]; }
