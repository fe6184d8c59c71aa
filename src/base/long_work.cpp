// SPDX-License-Identifier: MIT
#include "base/long_work.h"

namespace firma {

void LongWork::add(std::size_t done) {
    if (!options_.progress) return;
    const std::lock_guard<Lock> guard(telling_);
    done_ += done;
    if (!stopped_ && !options_.progress(done_ < count_ ? done_ : count_, count_, options_.user)) stopped_ = true;
}

}  // namespace firma
