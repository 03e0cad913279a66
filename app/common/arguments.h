// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::app {

/// Overwrites the passwords of addresses among the arguments of the program, which all users of the machine
/// can read (ps). Whatever needs them has a copy. Thread: the first one, before there are others.
void hidePasswords(int argc, char** argv);

} // namespace teleta::app
