// The camera on its way from one place to another, so that nobody loses sight of where they are.
#pragma once

#include <optional>

#include "render/view_params.h"

namespace ember {

class CameraFlight {
  public:
    static constexpr double kDuration = 0.3;  ///< [s]

    void begin(const CameraParams& from, const CameraParams& to, double now);
    /// Where it is at `now` [s], at last exactly at its goal; empty when there is no flight.
    [[nodiscard]] std::optional<CameraParams> at(double now);
    /// It stays where it is.
    void stop() { flying_ = false; }
    [[nodiscard]] bool flying() const { return flying_; }

  private:
    CameraParams from_, to_;
    double begun_ = 0;  // [s]
    bool flying_ = false;
};

}  // namespace ember
