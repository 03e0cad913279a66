// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/private_files.h"

#include <mutex>
#include <sys/stat.h>

namespace teleta::core {

namespace {

std::mutex g_umaskMutex;
int g_private = 0;     ///< guarded by g_umaskMutex
mode_t g_personal = 0; ///< guarded by g_umaskMutex: while g_private > 0

} // namespace

PrivateFiles::PrivateFiles() {
    const std::scoped_lock lock(g_umaskMutex);
    if (g_private++ == 0)
        g_personal = ::umask(S_IRWXG | S_IRWXO);
}

PrivateFiles::~PrivateFiles() {
    const std::scoped_lock lock(g_umaskMutex);
    if (--g_private == 0)
        ::umask(g_personal);
}

} // namespace teleta::core
