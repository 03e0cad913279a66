// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/messages.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::ros {
namespace {

std::string withoutComments(const std::string& text) {
    return std::regex_replace(text, std::regex("//[^\n]*"), "");
}

/// Names of structs that are not final.
std::vector<std::string> extensible(const std::string& idl) {
    static const std::regex structs(R"((@final\s+)?struct\s+(\w+))");
    std::vector<std::string> names;
    const std::string text = withoutComments(idl);
    for (auto i = std::sregex_iterator(text.begin(), text.end(), structs); i != std::sregex_iterator(); ++i) {
        if (!(*i)[1].matched)
            names.push_back((*i)[2]);
    }
    return names;
}

TEST(RosMessages, areAllFinal) {
    std::ifstream file(std::string(TELETA_SOURCE_DIR) + "/backend/ros/teleta_ros_messages.idl");
    std::stringstream text;
    text << file.rdbuf();
    ASSERT_NE(text.str().find("struct JointState_"), std::string::npos);
    EXPECT_EQ(extensible(text.str()), std::vector<std::string>{});
}

TEST(RosMessages, plantedStructsAreFound) {
    EXPECT_EQ(extensible("@final struct A { long a; };\n// struct B\nstruct C { long c; };"),
              std::vector<std::string>{"C"});
    EXPECT_EQ(extensible("@appendable struct D { long d; };"), std::vector<std::string>{"D"});
}

TEST(RosMessages, haveNoTypeInformation) {
    for (const MessageType& type : messageTypes()) {
        EXPECT_EQ(type.descriptor->type_information.sz, 0U) << type.name;
        EXPECT_EQ(type.descriptor->m_nkeys, 0U) << type.name;
    }
}

} // namespace
} // namespace teleta::ros
