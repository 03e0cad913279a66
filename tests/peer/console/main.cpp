// SPDX-License-Identifier: GPL-3.0-or-later
// What the console does with the kernel's devices, without its windows. Runs in the virtual machine of
// tests/peer/vm.
#include <QCoreApplication>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    qputenv("HOME", "/tmp"); // files of a bracelet: none
    testing::InitGoogleTest(&argc, argv);
    const QCoreApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
