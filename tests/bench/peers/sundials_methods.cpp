#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <memory>

#include "peer_methods.h"

namespace ember::peers {
namespace {

constexpr long kMostSteps = 10'000'000;

int evaluate(realtype, N_Vector y, N_Vector dydt, void* f) {
    (*static_cast<RightHandSide*>(f))(N_VGetArrayPointer(y), N_VGetArrayPointer(dydt));
    return 0;
}

// The library's objects of one solution.
class Session {
  public:
    explicit Session(const std::vector<double>& y) {
        if (SUNContext_Create(nullptr, &context) != 0) return;
        vector = N_VNew_Serial(static_cast<sunindextype>(y.size()), context);
        std::copy(y.begin(), y.end(), N_VGetArrayPointer(vector));
    }
    ~Session() {
        if (nonlinear != nullptr) SUNNonlinSolFree(nonlinear);
        if (vector != nullptr) N_VDestroy(vector);
        SUNContext_Free(&context);
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void read(std::vector<double>& y) const {
        std::copy_n(N_VGetArrayPointer(vector), y.size(), y.begin());
    }

    SUNContext context = nullptr;
    N_Vector vector = nullptr;
    SUNNonlinearSolver nonlinear = nullptr;
};

bool solve_cvode(RightHandSide& f, std::vector<double>& y, double duration, double tolerance) {
    Session s(y);
    void* solver = CVodeCreate(CV_ADAMS, s.context);
    s.nonlinear = SUNNonlinSol_FixedPoint(s.vector, 0, s.context);
    double reached = 0;
    const bool good = CVodeInit(solver, evaluate, 0.0, s.vector) == CV_SUCCESS &&
                      CVodeSetUserData(solver, &f) == CV_SUCCESS &&
                      CVodeSStolerances(solver, tolerance, tolerance) == CV_SUCCESS &&
                      CVodeSetNonlinearSolver(solver, s.nonlinear) == CV_SUCCESS &&
                      CVodeSetMaxNumSteps(solver, kMostSteps) == CV_SUCCESS &&
                      CVodeSetStopTime(solver, duration) == CV_SUCCESS &&
                      CVode(solver, duration, s.vector, &reached, CV_NORMAL) >= 0;
    s.read(y);
    CVodeFree(&solver);
    return good;
}

bool solve_erk(int order, RightHandSide& f, std::vector<double>& y, double duration,
               double tolerance) {
    Session s(y);
    void* solver = ERKStepCreate(evaluate, 0.0, s.vector, s.context);
    double reached = 0;
    const bool good = ERKStepSetUserData(solver, &f) == 0 && ERKStepSetOrder(solver, order) == 0 &&
                      ERKStepSStolerances(solver, tolerance, tolerance) == 0 &&
                      ERKStepSetMaxNumSteps(solver, kMostSteps) == 0 &&
                      ERKStepSetStopTime(solver, duration) == 0 &&
                      ERKStepEvolve(solver, duration, s.vector, &reached, ARK_NORMAL) >= 0;
    s.read(y);
    ERKStepFree(&solver);
    return good;
}

PeerMethod erk(int order) {
    return {"sundials", "arkode_erk" + std::to_string(order), false,
            [order](RightHandSide& f, std::vector<double>& y, double duration, double tolerance) {
                return solve_erk(order, f, y, duration, tolerance);
            }};
}

}  // namespace

std::vector<PeerMethod> sundials_methods() {
    return {{"sundials", "cvode_adams", false, solve_cvode}, erk(4), erk(5), erk(8)};
}

}  // namespace ember::peers
