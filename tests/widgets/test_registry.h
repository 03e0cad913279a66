// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <memory>
#include <vector>

namespace teleta::test {

/// Qt Test runs one object at a time; this lets several test classes share one program and one QApplication.
inline std::vector<std::function<std::unique_ptr<QObject>()>>& registry() {
    static std::vector<std::function<std::unique_ptr<QObject>()>> makers;
    return makers;
}

template <typename Test>
struct Registration {
    Registration() {
        registry().emplace_back([] { return std::make_unique<Test>(); });
    }
};

} // namespace teleta::test
