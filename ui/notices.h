// What the window has to say: shown for a moment, kept in a log.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ember {

enum class Severity { Info, Warning, Error };

struct Notice {
    double time = 0;  ///< [s] since the window opened
    Severity severity = Severity::Info;
    std::string text;
};

class Notices {
  public:
    static constexpr std::size_t kMostKept = 200;

    /// Warnings and errors also go to stderr. The same text again within a moment is one notice.
    void say(double now, Severity severity, std::string text);
    [[nodiscard]] const std::vector<Notice>& all() const { return all_; }
    /// Those that are still to be seen, oldest first.
    [[nodiscard]] std::vector<const Notice*> fresh(double now) const;
    /// Time until one of them goes [s], +inf when there is none.
    [[nodiscard]] double until_change(double now) const;
    void dismiss() { dismissed_ = all_.size(); }

  private:
    std::vector<Notice> all_;
    std::size_t dismissed_ = 0;
};

}  // namespace ember
