// SPDX-License-Identifier: GPL-3.0-or-later
// What start_benchmark.py compares the programs with: the least that a program of Qt Core does.
#include <QCoreApplication>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    return 0;
}
