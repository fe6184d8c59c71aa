// SPDX-License-Identifier: MIT
// Threads that are started as connections come, and kept for later ones.
#include "cli/connection_threads.h"

#include <system_error>
#include <utility>

namespace firma::cli {

void ConnectionThreads::enqueue(std::function<void()> connection) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(connection));
        if (waiting_.size() > free_ && threads_.size() < limit_) {
            try {
                threads_.emplace_back([this] { work(); });
                ++free_;
            } catch (const std::system_error&) {  // the system gives no more: it waits for one of those there are
                if (threads_.empty()) throw;
            }
        }
    }
    wake_.notify_one();
}

void ConnectionThreads::shutdown() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ConnectionThreads::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        wake_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        const std::function<void()> connection = std::move(waiting_.front());
        waiting_.pop_front();
        --free_;
        lock.unlock();
        connection();
        lock.lock();
        ++free_;
    }
}

}  // namespace firma::cli
