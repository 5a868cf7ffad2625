#include "tools/base/output/any_error.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tools/base/output/interruption.hpp"

namespace castaway::testbed {
namespace {

struct Unrelated {};

template <typename Thrown>
std::string text_of(const Thrown& thrown) {
  try {
    throw thrown;
  } catch (...) {
    return current_error_text();
  }
}

TEST(AnyError, SaysWhatAStandardExceptionSays) {
  EXPECT_EQ(text_of(std::runtime_error("no luck")), "no luck");
}

TEST(AnyError, NamesTheTypeOfAnyOther) {
  EXPECT_NE(text_of(Unrelated()).find("Unrelated"), std::string::npos);
  EXPECT_EQ(text_of(7), "a library failed with an exception of type int");
}

TEST(AnyError, LetsInterruptionsPass) {
  EXPECT_THROW((void)text_of(Interrupted{2, ""}), Interrupted);
}

}  // namespace
}  // namespace castaway::testbed
