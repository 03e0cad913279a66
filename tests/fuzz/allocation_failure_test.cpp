// SPDX-License-Identifier: GPL-3.0-or-later
// Every parser with memory refused: at the first allocation, at the second, and so on. It must answer as
// ever, or end with std::bad_alloc, which its callers turn into a message; and the next file must be read as
// if nothing had happened.
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/fuzz_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

/// Allocations that still succeed; negative: all do.
std::atomic<long long> g_left{-1};
std::atomic<long long> g_made{0};

void* allocate(std::size_t size, std::size_t alignment) {
    g_made.fetch_add(1, std::memory_order_relaxed);
    // One allocation fails, and those after it succeed: what cleans up needs memory, too.
    if (g_left.load(std::memory_order_relaxed) >= 0 && g_left.fetch_sub(1, std::memory_order_relaxed) == 0)
        return nullptr;
    if (alignment <= alignof(std::max_align_t))
        return std::malloc(size == 0 ? 1 : size);
    return std::aligned_alloc(alignment,
                              (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment);
}

void* allocateOrThrow(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
    void* memory = allocate(size, alignment);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t size) {
    return allocateOrThrow(size);
}
void* operator new[](std::size_t size) {
    return allocateOrThrow(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size, alignof(std::max_align_t));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace {

using teleta::fuzz::Bytes;
using teleta::fuzz::Input;

/// The shortest seed of each parser.
std::vector<Input> shortestSeeds() {
    std::vector<Input> shortest;
    for (const Input& input : teleta::fuzz::inputs("seed")) {
        if (shortest.empty() || shortest.back().target != input.target)
            shortest.push_back(input);
        else if (teleta::test::readAll(input.path).size() <
                 teleta::test::readAll(shortest.back().path).size())
            shortest.back() = input;
    }
    return shortest;
}

/// Of one parser, in memory that outlives the process that fails.
struct Progress {
    std::atomic<long long> next{0};        ///< allocation that is failed next
    std::atomic<long long> allocations{0}; ///< of one file
    std::atomic<long long> refused{0};     ///< ends by std::bad_alloc
    std::atomic<long long> answered{0};
};

/// In shared memory.
class SharedProgress {
public:
    SharedProgress()
        : m_memory(mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
        , m_progress(new (m_memory) Progress) {}
    ~SharedProgress() { munmap(m_memory, sizeof(Progress)); }
    SharedProgress(const SharedProgress&) = delete;
    SharedProgress& operator=(const SharedProgress&) = delete;
    Progress* operator->() const { return m_progress; }

private:
    void* m_memory;
    Progress* m_progress;
};

/// Fails each of the first allocations, and of the later ones so many that a few hundred are tried.
void failEach(teleta::fuzz::Target target, Bytes bytes, const SharedProgress& progress) {
    // What is made once and kept must not count.
    (void)target(bytes);
    g_made = 0;
    const bool accepted = target(bytes);
    progress->allocations = g_made.load();
    constexpr long long kEach = 200;
    constexpr long long kLater = 100;
    const long long stride = std::max(1LL, (progress->allocations - kEach) / kLater);
    while (progress->next < progress->allocations) {
        const long long at = progress->next;
        progress->next += at < kEach ? 1 : stride;
        try {
            g_left = at;
            (void)target(bytes);
            ++progress->answered;
        } catch (const std::bad_alloc&) {
            ++progress->refused;
        }
        g_left = -1;
        if (target(bytes) != accepted)
            _exit(2);
    }
}

class Parser : public testing::TestWithParam<Input> {};

} // namespace

TEST_P(Parser, withoutMemoryItEndsInGoodOrder) {
    const std::string bytes = teleta::test::readAll(GetParam().path);
    const teleta::fuzz::Target target = teleta::fuzz::targets().at(GetParam().target);
    const SharedProgress progress;
    do {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            // What a library says about its end is of no interest.
            (void)freopen("/dev/null", "w", stderr);
            failEach(target, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, progress);
            _exit(0);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        if (WIFSIGNALED(status)) {
            ASSERT_EQ(WTERMSIG(status), SIGABRT) << "at allocation " << progress->next - 1;
        } else {
            ASSERT_EQ(WEXITSTATUS(status), 0)
                << "the next file was not read as before, after allocation " << progress->next - 1;
        }
    } while (progress->next < progress->allocations);
    EXPECT_TRUE(progress->allocations == 0 || progress->refused + progress->answered > 0)
        << "it always ended the program";
}

INSTANTIATE_TEST_SUITE_P(Fuzzing, Parser, testing::ValuesIn(shortestSeeds()),
                         [](const testing::TestParamInfo<Input>& input) {
                             return teleta::fuzz::nameOf(input.param);
                         });
