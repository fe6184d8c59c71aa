// SPDX-License-Identifier: MIT
// A thread for each open connection, up to a limit: one that says nothing holds up no other.
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace firma::cli {

/// Starts a thread when a connection comes and none is free. Beyond the limit connections wait in order, until the time
/// limits of others end.
class ConnectionThreads final : public httplib::TaskQueue {
public:
    explicit ConnectionThreads(std::size_t limit) : limit_(limit) {}
    ~ConnectionThreads() override = default;

    void enqueue(std::function<void()> connection) override;
    /// Waits for all connections to end.
    void shutdown() override;

private:
    void work();

    const std::size_t limit_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::list<std::function<void()>> waiting_;
    std::vector<std::thread> threads_;
    std::size_t free_ = 0;  ///< threads without a connection
    bool ended_ = false;
};

}  // namespace firma::cli
