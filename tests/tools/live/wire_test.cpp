#include "tools/live/lines/wire.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Wire, MessagesArriveWholeHoweverTheyAreCut) {
  const std::string stream = to_wire(WireKind::kCommand, "{\"do\":\"play\"}") +
                             to_wire(WireKind::kFrame, std::string(5000, 'x')) +
                             to_wire(WireKind::kSaid, "");
  for (const std::size_t piece : {1UL, 7UL, 64UL, stream.size()}) {
    WireReader reader;
    std::vector<WireMessage> messages;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      reader.take(std::string_view(stream).substr(at, piece));
      while (auto message = reader.next()) messages.push_back(std::move(*message));
    }
    ASSERT_EQ(messages.size(), 3U);
    EXPECT_EQ(messages[0].kind, WireKind::kCommand);
    EXPECT_EQ(messages[0].body, "{\"do\":\"play\"}");
    EXPECT_EQ(messages[1].body, std::string(5000, 'x'));
    EXPECT_EQ(messages[2].kind, WireKind::kSaid);
    EXPECT_EQ(messages[2].body, "");
  }
}

TEST(Wire, OtherBytesAreRefused) {
  WireReader reader;
  reader.take(std::string(16, '\xff'));
  EXPECT_THROW(reader.next(), std::runtime_error);
}

TEST(WireReader, HoldsNothingOfWhatWasRead) {
  WireReader reader;
  for (int i = 0; i < 100; ++i) {
    reader.take(to_wire(WireKind::kFrame, std::string(1000, 'x')));
    while (reader.next()) {
    }
    EXPECT_EQ(reader.held(), 0U);
  }
}

}  // namespace
}  // namespace castaway::testbed
