#include "sim/fire.h"

#include <algorithm>
#include <cmath>

#include "sim/exp_array.h"
#include "sim/lighter.h"
#include "sim/math.h"
#include "sim/random.h"
#include "sim/vectorise.h"
#include "sim/wind.h"

namespace ember {
namespace {

// The first lighter has 0, and no stream of a node comes near those of the others.
std::uint64_t lighter_stream(std::size_t number) {
    return 0 - static_cast<std::uint64_t>(number);
}

std::uint64_t node_stream(std::size_t sheet, std::size_t node) {
    return 1 + (static_cast<std::uint64_t>(sheet) << 32) + node;
}

// One source of particles during one tick.
struct Emitter {
    std::uint64_t stream;
    Vector3 position, velocity;           // [m], [m/s] at the start of the tick
    double radius;                        // [m] particles start within this distance, horizontally
    double start, end;                    // [s] burns in [start, end)
    double rate;                          // [1/s]
    double rise;                          // [m/s]
    double strength;                      // [1]
    const LighterParams* path = nullptr;  // follows it instead
    // with fire.area_emission: the sheet and the lattice on which node `node` lies
    const SheetState* sheet = nullptr;
    const Lattice* lattice = nullptr;
    std::size_t node = 0;

    [[nodiscard]] Vector3 place(double at, double time) const {
        if (path != nullptr) return lighter_position(*path, at);
        return position + velocity * (at - time);
    }
};

// A random point on the quads around the emitter's node, relative to the node [m]. Its density is
// the node's share of the sheet by bilinear interpolation: 1 at the node, 0 at the next ones. Then
// the first moment of the heat ahead of a straight front, which makes the front's speed, is right
// to fourth order in the cell; with all particles at nodes it is too small by a term of second.
Vector3 point_around(const Emitter& emitter, std::uint64_t random) {
    const auto share = [random](std::uint64_t lane) {  // of density 2 (1 - share)
        return std::min(uniform_from(mix(random ^ lane)), uniform_from(mix(random ^ (lane + 1))));
    };
    const auto& position = emitter.sheet->position;
    const Index node = static_cast<Index>(emitter.node);
    const auto first = static_cast<int>(4.0 * uniform_from(mix(random ^ 7)));
    for (int i = 0; i < 4; ++i) {  // beyond the border there is no quad: another one's turn
        const int sector = (first + i) % 4;
        const Index cell = emitter.lattice->sector_cell(emitter.sheet->site[emitter.node], sector);
        if (cell == kNone) continue;
        const Quad& quad = emitter.sheet->quads[static_cast<std::size_t>(cell)];
        const auto corner = [&](int k) {
            return static_cast<std::size_t>(quad[static_cast<std::size_t>((sector + k) % 4)]);
        };
        if (quad[static_cast<std::size_t>(sector)] != node) continue;  // cut off
        const double a = share(8), b = share(10);
        return a * (1 - b) * (position.at(corner(1)) - position.at(corner(0))) +
               a * b * (position.at(corner(2)) - position.at(corner(0))) +
               (1 - a) * b * (position.at(corner(3)) - position.at(corner(0)));
    }
    return Vector3::Zero();
}

// What all particles that fly for the same time have in common; see advance_fire().
struct Flight {
    double ambient;        // [K]
    double half_buoyancy;  // [m/s^2]
    double span;           // [K]
    double cooling;        // [1] share of the excess temperature that is left
    double decay;          // [1] share of the speed that is left
    double reach;          // [s] distance per unit of initial speed
    double climb;          // [s^2] distance per unit of lift, from rest
    Vector3 carried;       // [m] by the wind, from rest
    Vector3 gained;        // [m/s] from the wind, from rest
};

// A particle in air that moves with W: v - W decays, so v gains W (1 - decay) and it is carried by
// W (h - reach).
Flight make_flight(const FireParams& fire, const Vector3& wind, double ambient, double h,
                   double cooling, double decay) {
    const double reach = fire.drag > 0 ? (1.0 - decay) / fire.drag : h;
    const double climb = fire.drag > 0 ? (h - reach) / fire.drag : 0.5 * h * h;
    const double span = fire.temperature - ambient;
    return {ambient,
            span > 0 ? 0.5 * fire.buoyancy : 0.0,
            span > 0 ? span : 1.0,
            cooling,
            decay,
            reach,
            climb,
            wind * (h - reach),
            wind * (1.0 - decay)};
}

// Exact flight of particles [begin, end). No exponential in it: they all fly for the same time.
EMBER_VECTORISED void fly(const Flight& flight, std::size_t begin, std::size_t end, double* x,
                          double* y, double* z, double* vx, double* vy, double* vz,
                          double* temperature) {
    const Flight f = flight;
    const double cx = f.carried.x(), cy = f.carried.y(), cz = f.carried.z();
    const double gx = f.gained.x(), gy = f.gained.y(), gz = f.gained.z();
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
        const double excess = temperature[i] - f.ambient, cooled = excess * f.cooling;
        const double lift = f.half_buoyancy * (excess + cooled) / f.span;
        x[i] += vx[i] * f.reach + cx;
        y[i] += (vy[i] * f.reach + lift * f.climb) + cy;
        z[i] += vz[i] * f.reach + cz;
        vx[i] = vx[i] * f.decay + gx;
        vy[i] = (vy[i] * f.decay + lift * f.reach) + gy;
        vz[i] = vz[i] * f.decay + gz;
        temperature[i] = f.ambient + cooled;
    }
}

void fly(const Flight& flight, std::size_t begin, std::size_t end, FireState& fire) {
    fly(flight, begin, end, fire.position.x.data(), fire.position.y.data(), fire.position.z.data(),
        fire.velocity.x.data(), fire.velocity.y.data(), fire.velocity.z.data(),
        fire.temperature.data());
}

void move_particles(const Params& params, const Vector3& wind, double dt, FireState& fire) {
    const FireParams& f = params.fire;
    fly(make_flight(f, wind, params.heat.ambient, dt, ember::exp(-dt / f.cooling_time),
                    ember::exp(-f.drag * dt)),
        0, fire.size(), fire);
}

// Particles born in this tick, each with its own time to fly until `end` [s].
void fly_new(const Params& params, const Vector3& wind, double end, std::size_t first,
             FireState& fire) {
    const FireParams& f = params.fire;
    constexpr std::size_t kAtOnce = 64;  // exponentials in one call
    double cooling[kAtOnce], decay[kAtOnce];
    for (std::size_t begin = first; begin < fire.size(); begin += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, fire.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            const double h = end - fire.birth[begin + i];
            cooling[i] = -h / f.cooling_time;
            decay[i] = -f.drag * h;
        }
        exp_array(cooling, static_cast<std::ptrdiff_t>(count));
        exp_array(decay, static_cast<std::ptrdiff_t>(count));
        for (std::size_t i = 0; i < count; ++i) {
            const Flight flight = make_flight(f, wind, params.heat.ambient,
                                              end - fire.birth[begin + i], cooling[i], decay[i]);
            fly(flight, begin + i, begin + i + 1, fire);
        }
    }
}

// Removes particles whose time is over, keeping the others in order. Most live on from tick to
// tick, so whole stretches between the dead are moved at once, and those before the first not.
void remove_dead(double now, FireState& fire) {
    const std::size_t count = fire.size();
    const std::vector<double>& death = fire.death;
    std::size_t kept = 0;
    while (kept < count && death[kept] > now)
        ++kept;
    for (std::size_t end = kept; end < count;) {
        std::size_t begin = end;
        while (begin < count && !(death[begin] > now))
            ++begin;
        end = begin;
        while (end < count && death[end] > now)
            ++end;
        for_each_array(fire, [&](auto& array) {
            std::copy(array.begin() + static_cast<std::ptrdiff_t>(begin),
                      array.begin() + static_cast<std::ptrdiff_t>(end),
                      array.begin() + static_cast<std::ptrdiff_t>(kept));
        });
        kept += end - begin;
    }
    for_each_array(fire, [&](auto& array) { array.resize(kept); });
}

// Adds a particle as it is at birth; fly_new() then moves it.
void emit_one(const FireParams& f, const Emitter& emitter, std::uint64_t random, std::uint64_t k,
              double birth, double time, double dt, FireState& fire) {
    const auto bits = [random](std::uint64_t lane) { return mix(random ^ lane); };
    const double life = f.life_min + uniform_from(bits(1)) * (f.life_max - f.life_min);
    const double death = birth + life;
    if (death <= time + dt) return;  // born and gone within one tick
    Vector3 position = emitter.place(birth, time);
    position.x() += emitter.radius * (2.0 * uniform_from(bits(2)) - 1.0);
    position.z() += emitter.radius * (2.0 * uniform_from(bits(3)) - 1.0);
    if (emitter.sheet != nullptr) position += point_around(emitter, random);
    Vector3 velocity =
        f.lateral_speed * Vector3(bell_from(bits(4)), bell_from(bits(5)), bell_from(bits(6)));
    velocity.y() += emitter.rise;
    fire.position.push_back(position);
    fire.velocity.push_back(velocity);
    fire.temperature.push_back(f.temperature);
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
    const std::uint64_t stream = random_stream(seed, RandomUse::Particle, emitter.stream);
    const double first = std::floor((from - emitter.start) * emitter.rate) - 1.0;
    for (auto k = static_cast<std::uint64_t>(std::max(0.0, first));; ++k) {
        const auto number = static_cast<double>(k);
        if (emitter.start + number / emitter.rate >= to) break;
        const std::uint64_t random = random_index(stream, k);
        const double jitter = uniform_from(mix(random));
        const double birth = emitter.start + (number + jitter) / emitter.rate;
        if (birth < from || birth >= to) continue;
        emit_one(params.fire, emitter, random, k, birth, time, dt, fire);
        ++counters.particles_born;
    }
}

void emit_from_node(const Params& params, std::uint64_t seed, std::size_t sheet_number,
                    const SheetState& sheet, const Lattice& lattice, std::size_t n, double time,
                    double dt, FireState& fire, StepCounters& counters) {
    ++counters.emitters_visited;
    const double area = sheet.initial_mass[n] / params.paper.grammage;
    Vector3 flame = sheet.position.at(n);
    flame.y() += params.fire.standoff;
    const SheetState* around = params.fire.area_emission ? &sheet : nullptr;
    emit(params, seed,
         {node_stream(sheet_number, n), flame, sheet.velocity.at(n), 0.0, sheet.ignition_time[n],
          time + dt, params.fire.emission * area, params.fire.rise_speed, params.fire.node_strength,
          nullptr, around, &lattice, n},
         time, dt, fire, counters);
}

}  // namespace

void advance_fire(const Params& params, const std::vector<LighterParams>& lighters,
                  std::uint64_t seed, double time, double dt, const std::vector<SheetState>& sheets,
                  const std::vector<const Lattice*>& lattices,
                  const std::vector<const ActiveNodes*>& active, FireState& fire,
                  StepCounters& counters) {
    const Vector3 wind = wind_velocity(params.wind, time + 0.5 * dt);
    if (fire.size() > 0) {
        counters.particles_moved += static_cast<std::int64_t>(fire.size());
        move_particles(params, wind, dt, fire);
        remove_dead(time + dt, fire);
    }
    const std::size_t older = fire.size();
    for (std::size_t i = 0; i < lighters.size(); ++i) {
        const LighterParams& l = lighters[i];
        if (!lighter_lit(l, time, dt)) continue;
        ++counters.emitters_visited;
        emit(params, seed,
             {lighter_stream(i),
              {l.x, l.y, l.z},
              Vector3::Zero(),
              l.radius,
              l.start,
              l.start + l.duration,
              l.rate,
              l.speed,
              l.strength,
              l.path.empty() ? nullptr : &l},
             time, dt, fire, counters);
    }
    for (std::size_t s = 0; s < sheets.size() && params.fire.emission > 0; ++s) {
        const SheetState& sheet = sheets[s];
        if (active[s] != nullptr) {
            for (const Index n : active[s]->burning)
                emit_from_node(params, seed, s, sheet, *lattices[s], static_cast<std::size_t>(n),
                               time, dt, fire, counters);
            continue;
        }
        for (std::size_t n = 0; n < sheet.phase.size(); ++n) {
            if (sheet.phase[n] == Phase::Burning)
                emit_from_node(params, seed, s, sheet, *lattices[s], n, time, dt, fire, counters);
        }
    }
    fly_new(params, wind, time + dt, older, fire);
}

}  // namespace ember
