#include "support/staged_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ember::test {
namespace {

constexpr double kTop = 0.45;                   // [m]
constexpr double kFrontSpeed = 0.03;            // [m/s]
constexpr double kBurningTemperature = 1100.0;  // [K]
constexpr double kResidue = 0.2;                // [1]

void burn_node(StagedWorld& s, std::size_t n) {
    const double from_corner = std::hypot(s.x[n] + 0.5 * s.width, s.y[n] - (kTop - s.height));
    if (from_corner < kFront) s.ignition_time[n] = s.time - (kFront - from_corner) / kFrontSpeed;
    if (from_corner < kBurntOut) {
        const double age = (kBurntOut - from_corner) / kFrontSpeed;
        s.phase[n] = Phase::BurntOut;
        s.mass[n] = kResidue * s.initial_mass[n];
        s.burnout_time[n] = s.time - age;
        s.temperature[n] = kAmbient + (kBurningTemperature - kAmbient) * std::exp(-2.0 * age);
    } else if (from_corner < kFront) {
        const double burnt = (kFront - from_corner) / (kFront - kBurntOut);
        s.phase[n] = Phase::Burning;
        s.mass[n] = (1.0 - (1.0 - kResidue) * burnt) * s.initial_mass[n];
        s.temperature[n] = kBurningTemperature;
    } else {
        const double ahead = (from_corner - kFront) / 0.006;
        s.temperature[n] = kAmbient + (kIgnition - kAmbient) * std::exp(-ahead) * 0.98;
    }
}

}  // namespace

void StagedWorld::add_particle(const Vector3& position, double kelvin) {
    fire_x.push_back(position.x());
    fire_y.push_back(position.y());
    fire_z.push_back(position.z());
    fire_vx.push_back(0.0);
    fire_vy.push_back(0.3);
    fire_vz.push_back(0.0);
    fire_temperature.push_back(kelvin);
    fire_birth.push_back(time - 0.1);
    fire_death.push_back(time + 0.3);
    fire_id.push_back((fire_id.size() + 1) * 0x9E3779B97F4A7C15u);
}

WorldView StagedWorld::view() const {
    SheetView sheet;
    sheet.row_count = rows;
    sheet.column_count = columns;
    sheet.width = width;
    sheet.height = height;
    sheet.x = x, sheet.y = y, sheet.z = z;
    sheet.vx = rest, sheet.vy = rest, sheet.vz = rest;
    sheet.temperature = temperature;
    sheet.mass = mass;
    sheet.initial_mass = initial_mass;
    sheet.ignition_time = ignition_time;
    sheet.burnout_time = burnout_time;
    sheet.phase = phase;
    sheet.site = site;
    sheet.quads = quads;
    sheet.topology_version = topology_version;
    WorldView view;
    view.time = time;
    view.ambient = kAmbient;
    view.ignition = kIgnition;
    view.residual_mass = kResidue;
    view.burning_time = (kFront - kBurntOut) / kFrontSpeed;
    view.fire_temperature = kFlame;
    view.ground = ground;
    view.lighters = {{Vector3(-0.5 * width, kTop - height - 0.02, 0.0), lighter_lit}};
    view.sheets = {sheet};
    view.particles = {fire_x,  fire_y,           fire_z,     fire_vx,    fire_vy,
                      fire_vz, fire_temperature, fire_birth, fire_death, fire_id};
    return view;
}

StagedWorld hanging_sheet(int rows, int columns) {
    StagedWorld s;
    s.rows = rows;
    s.columns = columns;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            s.x.push_back(s.width * (static_cast<double>(row) / (rows - 1) - 0.5));
            s.y.push_back(kTop - s.height * column / (columns - 1));
            s.site.push_back(row * columns + column);
        }
    }
    const std::size_t count = s.x.size();
    s.z.assign(count, 0.0);
    s.rest.assign(count, 0.0);
    s.temperature.assign(count, kAmbient);
    s.mass.assign(count, 3e-6);
    s.initial_mass.assign(count, 3e-6);
    s.ignition_time.assign(count, std::numeric_limits<double>::infinity());
    s.burnout_time = s.ignition_time;
    s.phase.assign(count, Phase::Unburnt);
    for (Index row = 0; row + 1 < rows; ++row) {
        for (Index column = 0; column + 1 < columns; ++column) {
            const Index n = row * columns + column;
            s.quads.push_back({n, n + 1, n + columns + 1, n + columns});
        }
    }
    return s;
}

StagedWorld burning_sheet(int rows, int columns, int particles) {
    StagedWorld s = hanging_sheet(rows, columns);
    for (std::size_t n = 0; n < s.x.size(); ++n) {
        burn_node(s, n);
        s.z[n] = 0.02 * std::sin(12.0 * s.x[n]) + 0.015 * std::cos(9.0 * s.y[n]);
    }
    for (int i = 0; i < particles; ++i) {
        // along the arc of the front, at most 6 cm above it and 2 cm before or behind
        const double angle = 1.5 * (i % 61) / 60.0, rise = 0.06 * (i % 17) / 16.0;
        const double depth = 0.02 * ((i % 7) / 3.0 - 1.0);
        s.add_particle({-0.5 * s.width + kFront * std::cos(angle),
                        kTop - s.height + kFront * std::sin(angle) + rise, depth},
                       kFlame - 4000.0 * rise);
    }
    return s;
}

FireCells fire_at(const Vector3& place, int particles) {
    StagedWorld staged = hanging_sheet(3, 3);
    for (int i = 0; i < particles; ++i)
        staged.add_particle(place, kFlame);
    return FireCells(staged.view());
}

}  // namespace ember::test
