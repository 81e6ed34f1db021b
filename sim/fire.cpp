#include "sim/fire.h"

#include <algorithm>
#include <cmath>

#include "sim/math.h"
#include "sim/random.h"

namespace ember {
namespace {

constexpr std::uint64_t kLighterStream = 0;

std::uint64_t node_stream(std::size_t sheet, std::size_t node) {
    return 1 + (static_cast<std::uint64_t>(sheet) << 32) + node;
}

// One source of particles during one tick.
struct Emitter {
    std::uint64_t stream;
    Vector3 position, velocity;  // [m], [m/s] at the start of the tick
    double radius;               // [m] particles start within this distance, horizontally
    double start, end;           // [s] burns in [start, end)
    double rate;                 // [1/s]
    double rise;                 // [m/s]
    double strength;             // [1]
};

// Exact flight over `h` [s] of one particle; see advance_fire().
void fly(const FireParams& fire, double ambient, double h, double& x, double& y, double& z,
         Vector3& v, double& temperature) {
    const double excess = temperature - ambient;
    const double cooled = excess * ember::exp(-h / fire.cooling_time);
    const double span = fire.temperature - ambient;
    const double lift = span > 0 ? fire.buoyancy * 0.5 * (excess + cooled) / span : 0.0;
    const double decay = ember::exp(-fire.drag * h);
    // distance covered per unit of initial speed, and by unit lift from rest
    const double reach = fire.drag > 0 ? (1.0 - decay) / fire.drag : h;
    const double climb = fire.drag > 0 ? (h - reach) / fire.drag : 0.5 * h * h;
    x += v.x() * reach;
    y += v.y() * reach + lift * climb;
    z += v.z() * reach;
    v *= decay;
    v.y() += lift * reach;
    temperature = ambient + cooled;
}

void move_particles(const Params& params, double dt, FireState& fire) {
    for (std::size_t i = 0; i < fire.size(); ++i) {
        Vector3 v = fire.velocity.at(i);
        fly(params.fire, params.heat.ambient, dt, fire.position.x[i], fire.position.y[i],
            fire.position.z[i], v, fire.temperature[i]);
        fire.velocity.set(i, v);
    }
}

// Removes particles whose time is over, keeping the others in order.
void remove_dead(double now, FireState& fire) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < fire.size(); ++i) {
        if (fire.death[i] <= now) continue;
        if (kept != i) {
            fire.position.set(kept, fire.position.at(i));
            fire.velocity.set(kept, fire.velocity.at(i));
            fire.temperature[kept] = fire.temperature[i];
            fire.strength[kept] = fire.strength[i];
            fire.birth[kept] = fire.birth[i];
            fire.death[kept] = fire.death[i];
            fire.id[kept] = fire.id[i];
        }
        ++kept;
    }
    fire.position.resize(kept);
    fire.velocity.resize(kept);
    fire.temperature.resize(kept);
    fire.strength.resize(kept);
    fire.birth.resize(kept);
    fire.death.resize(kept);
    fire.id.resize(kept);
}

void emit_one(const Params& params, std::uint64_t seed, const Emitter& emitter, std::uint64_t k,
              double birth, double time, double dt, FireState& fire) {
    const auto bits = [&](std::uint64_t lane) {
        return random_bits(seed, RandomUse::Particle, emitter.stream, k, lane);
    };
    const FireParams& f = params.fire;
    const double life = f.life_min + uniform_from(bits(1)) * (f.life_max - f.life_min);
    const double death = birth + life;
    if (death <= time + dt) return;  // born and gone within one tick
    Vector3 position = emitter.position + emitter.velocity * (birth - time);
    position.x() += emitter.radius * (2.0 * uniform_from(bits(2)) - 1.0);
    position.z() += emitter.radius * (2.0 * uniform_from(bits(3)) - 1.0);
    Vector3 velocity =
        f.lateral_speed * Vector3(bell_from(bits(4)), bell_from(bits(5)), bell_from(bits(6)));
    velocity.y() += emitter.rise;
    double temperature = f.temperature;
    fly(f, params.heat.ambient, time + dt - birth, position.x(), position.y(), position.z(),
        velocity, temperature);
    fire.position.push_back(position);
    fire.velocity.push_back(velocity);
    fire.temperature.push_back(temperature);
    fire.strength.push_back(emitter.strength);
    fire.birth.push_back(birth);
    fire.death.push_back(death);
    fire.id.push_back(mix(emitter.stream * 0x10001ull + (k << 20)));
}

// Particles that `emitter` releases in [time, time + dt).
void emit(const Params& params, std::uint64_t seed, const Emitter& emitter, double time, double dt,
          FireState& fire, StepCounters& counters) {
    const double from = std::max(time, emitter.start), to = std::min(time + dt, emitter.end);
    if (!(to > from) || !(emitter.rate > 0)) return;
    const double first = std::floor((from - emitter.start) * emitter.rate) - 1.0;
    for (auto k = static_cast<std::uint64_t>(std::max(0.0, first));; ++k) {
        const auto number = static_cast<double>(k);
        if (emitter.start + number / emitter.rate >= to) break;
        const double jitter = random_uniform(seed, RandomUse::Particle, emitter.stream, k, 0);
        const double birth = emitter.start + (number + jitter) / emitter.rate;
        if (birth < from || birth >= to) continue;
        emit_one(params, seed, emitter, k, birth, time, dt, fire);
        ++counters.particles_born;
    }
}

}  // namespace

bool lighter_lit(const LighterParams& lighter, double time, double dt) {
    return lighter.on && time + dt > lighter.start && time < lighter.start + lighter.duration;
}

void advance_fire(const Params& params, std::uint64_t seed, double time, double dt,
                  const std::vector<SheetState>& sheets, FireState& fire, StepCounters& counters) {
    counters.particles_moved += static_cast<std::int64_t>(fire.size());
    move_particles(params, dt, fire);
    remove_dead(time + dt, fire);
    const LighterParams& l = params.lighter;
    if (lighter_lit(l, time, dt)) {
        emit(params, seed,
             {kLighterStream,
              {l.x, l.y, l.z},
              Vector3::Zero(),
              l.radius,
              l.start,
              l.start + l.duration,
              l.rate,
              l.speed,
              l.strength},
             time, dt, fire, counters);
    }
    if (!(params.fire.emission > 0)) return;
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const SheetState& sheet = sheets[s];
        for (std::size_t n = 0; n < sheet.phase.size(); ++n) {
            if (sheet.phase[n] != Phase::Burning) continue;
            const double area = sheet.initial_mass[n] / params.paper.grammage;
            emit(params, seed,
                 {node_stream(s, n), sheet.position.at(n), sheet.velocity.at(n), 0.0,
                  sheet.ignition_time[n], time + dt, params.fire.emission * area,
                  params.fire.rise_speed, params.fire.node_strength},
                 time, dt, fire, counters);
        }
    }
}

}  // namespace ember
