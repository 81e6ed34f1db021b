// Compiled with -O3 -march=native and with fused multiply-add, as the library is headers only.
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "peer_methods.h"

namespace ember::peers {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;
using Fehlberg = odeint::runge_kutta_fehlberg78<State>;

// The library's multistep methods start with classical Runge-Kutta, which would limit their order;
// it lets the user choose another.
template <std::size_t Steps>
using Adams = odeint::adams_bashforth_moulton<Steps, State, double, State, double,
                                              odeint::range_algebra, odeint::default_operations,
                                              odeint::initially_resizer, Fehlberg>;

auto system_of(RightHandSide& f) {
    return [&f](const State& y, State& dydt, double) {
        dydt.resize(y.size());
        f(y.data(), dydt.data());
    };
}

template <class Stepper>
PeerMethod fixed(std::string name) {
    return {"odeint", std::move(name), true,
            [](RightHandSide& f, State& y, double duration, double step) {
                const auto steps = static_cast<std::size_t>(std::ceil(duration / step - 1e-9));
                odeint::integrate_n_steps(Stepper(), system_of(f), y, 0.0,
                                          duration / static_cast<double>(steps), steps);
                return true;
            }};
}

template <class Stepper>
PeerMethod controlled(std::string name) {
    return {"odeint", std::move(name), false,
            [](RightHandSide& f, State& y, double duration, double tolerance) {
                odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, Stepper()),
                                           system_of(f), y, 0.0, duration, 1e-3);
                return true;
            }};
}

}  // namespace

std::vector<PeerMethod> odeint_methods() {
    return {fixed<odeint::runge_kutta4<State>>("runge_kutta4"),
            controlled<odeint::runge_kutta_dopri5<State>>("runge_kutta_dopri5"),
            controlled<Fehlberg>("runge_kutta_fehlberg78"),
            fixed<Adams<4>>("adams_bashforth_moulton<4>"),
            fixed<Adams<5>>("adams_bashforth_moulton<5>"),
            fixed<Adams<6>>("adams_bashforth_moulton<6>"),
            fixed<Adams<7>>("adams_bashforth_moulton<7>"),
            fixed<Adams<8>>("adams_bashforth_moulton<8>")};
}

}  // namespace ember::peers
