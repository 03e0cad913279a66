// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::core {

/// Base of the abstract classes: deleted through a pointer to them, neither copied nor moved.
class Interface {
public:
    virtual ~Interface() = default;
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

protected:
    Interface() = default;
};

} // namespace teleta::core
