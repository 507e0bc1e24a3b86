#include "tools/view/session/session_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

TEST(SessionCommand, EachIsRead) {
  EXPECT_EQ(parse_command(R"({"do":"run"})").action, Action::run);
  EXPECT_EQ(parse_command(R"({"id":7,"do":"add_seed"})").id, 7U);
  const SessionCommand move = parse_command(R"({"do":"move_seed","region":3,"id":4294967294})");
  EXPECT_EQ(move.region, 3U);
  EXPECT_EQ(move.id, 4294967294U);
  EXPECT_EQ(parse_command(R"({"do":"remesh","vertices":4})").vertices, 4U);
  EXPECT_EQ(parse_command(R"({"do":"save","what":"picture"})").what, Saving::picture);
  EXPECT_EQ(parse_command(R"({"do":"set","graph":"mixed"})").changes["graph"], "mixed");
}

TEST(SessionCommand, WhatIsNoneIsRefusedInOneLine) {
  const std::string deep(100'000, '[');
  for (const std::string& text : {
           std::string(),
           std::string("run"),
           std::string("[]"),
           std::string("null"),
           std::string("{}"),
           deep,
           "{\"do\":" + deep,
           std::string(R"({"do":1})"),
           std::string(R"({"do":"quit"})"),
           std::string(R"({"do":"run","do2":1})"),
           std::string(R"({"do":"run"} {"do":"run"})"),
           std::string("{\"do\":\"run\0\"}", 13),
           std::string("{\"do\":\"\xff\"}"),
           std::string(R"({"do":["run"]})"),
           std::string(R"({"do":"add_seed"})"),
           std::string(R"({"do":"add_seed","id":-1})"),
           std::string(R"({"do":"add_seed","id":1.5})"),
           std::string(R"({"do":"add_seed","id":1e3})"),
           std::string(R"({"do":"add_seed","id":"1"})"),
           std::string(R"({"do":"add_seed","id":null})"),
           std::string(R"({"do":"add_seed","id":4294967295})"),
           std::string(R"({"do":"add_seed","id":18446744073709551616})"),
           std::string(R"({"do":"add_seed","id":1,"region":1})"),
           std::string(R"({"do":"move_seed","id":1})"),
           std::string(R"({"do":"move_seed","id":1,"region":{}})"),
           std::string(R"({"do":"remove_seed","region":true})"),
           std::string(R"({"do":"remesh","vertices":3})"),
           std::string(R"({"do":"remesh","vertices":1e308})"),
           std::string(R"({"do":"remesh"})"),
           std::string(R"({"do":"save","what":"../../etc/passwd"})"),
           std::string(R"({"do":"save","what":"result","path":"/etc/passwd"})"),
           std::string(R"({"do":"save"})"),
       }) {
    SCOPED_TRACE(text.substr(0, 80));
    try {
      parse_command(text);
      ADD_FAILURE() << "was taken";
    } catch (const InvalidInput& error) {
      const std::string message = error.what();
      EXPECT_LT(message.size(), 400U);
      EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) {
        return c >= ' ' && c <= '~';
      })) << message;
    }
  }
}

}  // namespace
}  // namespace geolloyd
