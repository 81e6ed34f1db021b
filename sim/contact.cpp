#include "sim/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/contact_geometry.h"
#include "sim/param_table.h"

namespace ember {
namespace {

constexpr double kSlack = 0.1;  // [1] of the thickness, within which contacts are kept ready
constexpr double kSoft = 0.1;   // [1] of the thickness, by which resting things may give way

std::size_t as_size(Index i) {
    return static_cast<std::size_t>(i);
}

Index body_of(ContactScratch& s, Index sheet, Index node) {
    Index& body = s.body_of[as_size(sheet)][as_size(node)];
    if (body == kNone) {
        body = static_cast<Index>(s.owner.size());
        s.owner.push_back({sheet, node});
    }
    return body;
}

bool is_asleep(const ContactSheet& c, Index node) {
    if (c.asleep == nullptr) return false;
    return c.asleep[c.lattice->row_of(c.sheet->site[as_size(node)])] != 0;
}

// A number to every node that may be pushed, and room for the contact forces on its sheet.
void number_bodies(ContactScratch& s) {
    s.owner.clear();
    s.body_of.resize(s.sheets.size());
    for (std::size_t i = 0; i < s.sheets.size(); ++i)
        s.body_of[i].assign(s.sheets[i].sheet->mass.size(), kNone);
    for (const SheetNode& node : s.near.on_ground)
        body_of(s, node.sheet, node.node);
    for (const NearPair& pair : s.near.pairs) {
        body_of(s, pair.sheet, pair.node);
        for (const Index node : s.sheets[as_size(pair.other)].sheet->quads[as_size(pair.quad)])
            body_of(s, pair.other, node);
    }
    for (const NearEdges& pair : s.near.edges) {
        for (const Index node : s.near.borders[as_size(pair.sheet)].ends[as_size(pair.edge)])
            body_of(s, pair.sheet, node);
        for (const Index node : s.near.borders[as_size(pair.other)].ends[as_size(pair.other_edge)])
            body_of(s, pair.other, node);
    }
    s.other_force.resize(s.owner.size());
    s.bodies.inverse_mass.resize(s.owner.size());
    for (std::size_t b = 0; b < s.owner.size(); ++b) {
        const ContactSheet& c = s.sheets[as_size(s.owner[b].sheet)];
        const std::size_t n = as_size(s.owner[b].node);
        s.other_force[b] = c.loads->force.at(n);
        s.bodies.inverse_mass[b] = is_asleep(c, s.owner[b].node) ? 0.0 : c.loads->inverse_mass[n];
        Vector3Array& contact = c.loads->contact;
        if (contact.size() != 0) continue;
        for (std::vector<double>* axis : {&contact.x, &contact.y, &contact.z})
            axis->assign(c.sheet->mass.size(), 0.0);
    }
}

// Velocities without contact: at the start of the interval, and at its end.
void predict(double interval, ContactScratch& s) {
    s.start.resize(s.owner.size());
    s.bodies.velocity.resize(s.owner.size());
    for (std::size_t b = 0; b < s.owner.size(); ++b) {
        const ContactSheet& c = s.sheets[as_size(s.owner[b].sheet)];
        s.start[b] = c.sheet->velocity.at(as_size(s.owner[b].node));
        s.bodies.velocity[b] = s.start[b] + interval * s.bodies.inverse_mass[b] * s.other_force[b];
    }
}

Path path_of(const ContactScratch& s, Index sheet, Index node, double interval) {
    const Vector3 from = s.sheets[as_size(sheet)].sheet->position.at(as_size(node));
    const Index body = s.body_of[as_size(sheet)][as_size(node)];
    return {from, from + interval * s.bodies.velocity[as_size(body)]};
}

// Adds the contact of near thing number `source`.
void add(double gap, double kept, double interval, std::size_t source, Contact contact,
         ContactScratch& s) {
    double speed = 0.0;
    for (std::size_t k = 0; k < contact.bodies; ++k)
        speed += contact.weight[k] * s.start[as_size(contact.body[k])].dot(contact.normal);
    contact.least = least_speed(gap, speed, interval, kSoft * kept);
    contact.guess = s.needed[source];
    contact.source = static_cast<Index>(source);
    s.contacts.push_back(contact);
}

void touch_ground(const Params& params, double thickness, double interval, ContactScratch& s) {
    for (std::size_t i = 0; i < s.near.on_ground.size(); ++i) {
        const SheetNode& node = s.near.on_ground[i];
        const Path path = path_of(s, node.sheet, node.node, interval);
        const double gap = path.from.y() - 0.5 * thickness;
        const double fall = path.from.y() - path.to.y();
        if (gap > kSlack * thickness && !(gap < 2.0 * fall)) continue;
        const Index body = s.body_of[as_size(node.sheet)][as_size(node.node)];
        add(gap, thickness, interval, i,
            {.bodies = 1,
             .body = {body},
             .weight = {1},
             .normal = Vector3::UnitY(),
             .friction = params.contact.ground_friction},
            s);
    }
}

// The two triangles of a quad, by corner.
constexpr std::array<std::array<std::size_t, 3>, 2> kTriangles = {{{0, 1, 2}, {0, 2, 3}}};

// Distance that the parts of a sheet keep from another, or from each other. The leaves of a pad are
// held closer together than loose paper comes to rest.
double distance_kept(const ContactScratch& s, Index sheet, Index other, double thickness) {
    const ContactSheet &ours = s.sheets[as_size(sheet)], &theirs = s.sheets[as_size(other)];
    if (sheet != other) {
        const double gap = std::min(ours.gap, theirs.gap);
        return gap > 0 ? std::min(thickness, gap) : thickness;
    }
    return std::min({thickness, theirs.lattice->row_spacing, theirs.lattice->column_spacing});
}

void touch_paper(const Params& params, double thickness, double interval, ContactScratch& s) {
    for (std::size_t i = 0; i < s.near.pairs.size(); ++i) {
        const NearPair& pair = s.near.pairs[i];
        const double kept = distance_kept(s, pair.sheet, pair.other, thickness);
        const Path node = path_of(s, pair.sheet, pair.node, interval);
        const Quad& quad = s.sheets[as_size(pair.other)].sheet->quads[as_size(pair.quad)];
        std::array<Path, 4> corner;
        for (std::size_t k = 0; k < 4; ++k)
            corner[k] = path_of(s, pair.other, quad[k], interval);
        for (const auto& [a, b, c] : kTriangles) {
            Touch touch;
            if (!meet(node, {corner[a], corner[b], corner[c]}, kept, kSlack * kept,
                      pair.sheet > pair.other, touch)) {
                continue;
            }
            const std::vector<Index>& bodies = s.body_of[as_size(pair.other)];
            add(touch.gap, kept, interval, s.near.on_ground.size() + i,
                {.body = {s.body_of[as_size(pair.sheet)][as_size(pair.node)],
                          bodies[as_size(quad[a])], bodies[as_size(quad[b])],
                          bodies[as_size(quad[c])]},
                 .weight = touch.weight,
                 .normal = touch.normal,
                 .friction = params.contact.friction},
                s);
            break;
        }
    }
}

void touch_edges(const Params& params, double thickness, double interval, ContactScratch& s) {
    const std::size_t first = s.near.on_ground.size() + s.near.pairs.size();
    for (std::size_t i = 0; i < s.near.edges.size(); ++i) {
        const NearEdges& pair = s.near.edges[i];
        const double kept = distance_kept(s, pair.sheet, pair.other, thickness);
        const auto& [a, b] = s.near.borders[as_size(pair.sheet)].ends[as_size(pair.edge)];
        const auto& [c, d] = s.near.borders[as_size(pair.other)].ends[as_size(pair.other_edge)];
        Touch touch;
        if (!meet({path_of(s, pair.sheet, a, interval), path_of(s, pair.sheet, b, interval)},
                  {path_of(s, pair.other, c, interval), path_of(s, pair.other, d, interval)}, kept,
                  kSlack * kept, pair.sheet > pair.other, touch)) {
            continue;
        }
        const std::vector<Index>&ours = s.body_of[as_size(pair.sheet)],
              &theirs = s.body_of[as_size(pair.other)];
        add(touch.gap, kept, interval, first + i,
            {.body = {ours[as_size(a)], ours[as_size(b)], theirs[as_size(c)], theirs[as_size(d)]},
             .weight = touch.weight,
             .normal = touch.normal,
             .friction = params.contact.friction},
            s);
    }
}

// Rows that sleep beside something that moves over them wake.
void wake_touched(double sleep_speed, ContactScratch& s) {
    for (const Contact& contact : s.contacts) {
        double fastest = 0.0;
        const std::span bodies(contact.body.data(), contact.bodies);
        for (const Index body : bodies)
            fastest = std::max(fastest, s.start[as_size(body)].norm());
        if (!(fastest > sleep_speed)) continue;
        for (const Index body : bodies) {
            const SheetNode& owner = s.owner[as_size(body)];
            const ContactSheet& c = s.sheets[as_size(owner.sheet)];
            if (!is_asleep(c, owner.node)) continue;
            const Index row = c.lattice->row_of(c.sheet->site[as_size(owner.node)]);
            c.sheet->quiet_ticks[as_size(row)] = 0;
        }
    }
}

}  // namespace

double contact_thickness(const Params& params) {
    return std::max(params.contact.thickness, caliper(params.paper));
}

std::int64_t find_contacts(const Params& params, double dt, ContactScratch& s,
                           StepCounters& counters) {
    s.shapes.clear();
    for (const ContactSheet& c : s.sheets) {
        s.shapes.push_back({c.lattice, c.sheet});
        for (std::vector<double>* axis :
             {&c.loads->contact.x, &c.loads->contact.y, &c.loads->contact.z})
            axis->clear();
    }
    const double thickness = contact_thickness(params);
    const double fall = kSlack * thickness + params.world.gravity * dt * dt;
    find_near(params, dt, thickness, fall, s.shapes, s.near, counters);
    if (s.near.empty()) return 1;
    number_bodies(s);
    s.needed.assign(s.near.on_ground.size() + s.near.pairs.size() + s.near.edges.size(),
                    Vector3::Zero());
    return static_cast<std::int64_t>(std::max(1.0, std::ceil(dt / params.contact.interval)));
}

void press_contacts(const Params& params, double interval, ContactScratch& s,
                    StepCounters& counters) {
    const double thickness = contact_thickness(params);
    predict(interval, s);
    s.contacts.clear();
    touch_ground(params, thickness, interval, s);
    touch_paper(params, thickness, interval, s);
    touch_edges(params, thickness, interval, s);
    if (params.numerics.sleep_speed > 0) wake_touched(params.numerics.sleep_speed, s);
    if (!s.contacts.empty())
        counters.contact_sweeps += solve_contacts(s.contacts, s.bodies);
    else
        s.bodies.impulse.assign(s.owner.size(), Vector3::Zero());
    std::fill(s.needed.begin(), s.needed.end(), Vector3::Zero());
    for (const Contact& contact : s.contacts)
        s.needed[as_size(contact.source)] = contact.impulse();
    counters.contacts += static_cast<std::int64_t>(s.contacts.size());
    for (std::size_t b = 0; b < s.owner.size(); ++b) {
        NodeLoads& loads = *s.sheets[as_size(s.owner[b].sheet)].loads;
        const std::size_t n = as_size(s.owner[b].node);
        const Vector3 force = s.bodies.impulse[b] / interval;
        loads.contact.set(n, force);
        loads.force.set(n, s.other_force[b] + force);
    }
}

}  // namespace ember
