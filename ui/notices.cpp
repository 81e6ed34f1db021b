#include "ui/notices.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace ember {
namespace {

constexpr double kInfoShown = 4, kTroubleShown = 12;  // [s]
constexpr double kSame = 1;                           // [s]

double until(const Notice& notice, double now) {
    const double shown = notice.severity == Severity::Info ? kInfoShown : kTroubleShown;
    return notice.time + shown - now;
}

}  // namespace

void Notices::say(double now, Severity severity, std::string text) {
    if (!all_.empty() && all_.back().text == text && now - all_.back().time < kSame) {
        all_.back().time = now;
        return;
    }
    if (severity != Severity::Info) std::fprintf(stderr, "emberleaf: %s\n", text.c_str());
    all_.push_back({now, severity, std::move(text)});
    if (all_.size() <= kMostKept) return;
    all_.erase(all_.begin());
    dismissed_ -= dismissed_ > 0 ? 1 : 0;
}

std::vector<const Notice*> Notices::fresh(double now) const {
    std::vector<const Notice*> list;
    for (std::size_t i = dismissed_; i < all_.size(); ++i) {
        if (until(all_[i], now) > 0) list.push_back(&all_[i]);
    }
    return list;
}

double Notices::until_change(double now) const {
    double soonest = std::numeric_limits<double>::infinity();
    for (const Notice* notice : fresh(now))
        soonest = std::min(soonest, until(*notice, now));
    return soonest;
}

}  // namespace ember
