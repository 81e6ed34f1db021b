#include "app/bench/svg.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/xml_text.h"

namespace ember {
namespace {

// Okabe and Ito's palette, which colour-blind readers can tell apart, and a grey.
constexpr std::array<std::string_view, 8> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                      "#E69F00", "#56B4E9", "#000000", "#7A7A7A"};

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string attribute(std::string_view name, double value) {
    return ' ' + std::string(name) + "=\"" + number(value) + '"';
}

std::string attribute(std::string_view name, std::string_view value) {
    return ' ' + std::string(name) + "=\"" + std::string(value) + '"';
}

std::string list(const std::vector<PagePoint>& points) {
    std::string text;
    for (const PagePoint& p : points)
        text += (text.empty() ? "" : " ") + number(p.x) + ',' + number(p.y);
    return text;
}

// Corners on a circle; `inner` < 1 puts every other corner further in (a star).
std::vector<PagePoint> corners(PagePoint centre, double radius, int count, double turn,
                               double inner = 1) {
    std::vector<PagePoint> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + turn) / count;
        const double r = i % 2 == 0 ? radius : inner * radius;
        points.push_back({centre.x + r * std::sin(angle), centre.y - r * std::cos(angle)});
    }
    return points;
}

}  // namespace

SvgPage::SvgPage(double width, double height) : width_(width), height_(height) {
    rectangle({0, 0}, width, height, "#FFFFFF");
}

void SvgPage::line(PagePoint from, PagePoint to, std::string_view colour, double width,
                   std::string_view dashes) {
    body_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
             attribute("y2", to.y) + attribute("stroke", colour) + attribute("stroke-width", width);
    if (!dashes.empty()) body_ += attribute("stroke-dasharray", dashes);
    body_ += "/>\n";
}

void SvgPage::polyline(const std::vector<PagePoint>& points, std::string_view colour,
                       double width) {
    body_ += "<polyline fill=\"none\" stroke-linejoin=\"round\"" +
             attribute("points", list(points)) + attribute("stroke", colour) +
             attribute("stroke-width", width) + "/>\n";
}

void SvgPage::polygon(const std::vector<PagePoint>& points, std::string_view fill,
                      std::string_view outline, double width) {
    body_ += "<polygon" + attribute("points", list(points)) + attribute("fill", fill) +
             attribute("stroke", outline) + attribute("stroke-width", width) + "/>\n";
}

void SvgPage::circle(PagePoint centre, double radius, std::string_view fill,
                     std::string_view outline, double width) {
    body_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) +
             attribute("r", radius) + attribute("fill", fill) + attribute("stroke", outline) +
             attribute("stroke-width", width) + "/>\n";
}

void SvgPage::rectangle(PagePoint corner, double width, double height, std::string_view fill,
                        double opacity) {
    body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) +
             attribute("width", width) + attribute("height", height) + attribute("fill", fill);
    if (opacity < 1) body_ += attribute("fill-opacity", opacity);
    body_ += "/>\n";
}

void SvgPage::text(PagePoint at, std::string_view words, const TextStyle& style) {
    constexpr std::array<std::string_view, 3> kAnchors = {"start", "middle", "end"};
    body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) +
             attribute("font-size", style.size) +
             attribute("text-anchor", kAnchors[static_cast<std::size_t>(style.anchor)]) +
             attribute("fill", style.colour);
    if (style.bold) body_ += " font-weight=\"bold\"";
    if (style.turn != 0) {
        body_ += attribute("transform", "rotate(" + number(style.turn) + ' ' + number(at.x) + ' ' +
                                            number(at.y) + ')');
    }
    body_ += '>' + xml_escaped(words) + "</text>\n";
}

std::string SvgPage::svg() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
           attribute("width", width_) + attribute("height", height_) +
           attribute("viewBox", "0 0 " + number(width_) + ' ' + number(height_)) +
           " font-family=\"DejaVu Sans, Verdana, Helvetica, sans-serif\">\n" + body_ + "</svg>\n";
}

std::string_view series_colour(std::size_t i) {
    return kColours[i % kColours.size()];
}

void draw_marker(SvgPage& page, std::size_t i, PagePoint centre, double radius) {
    const std::string_view colour = series_colour(i);
    // the second round of colours has hollow markers
    const std::string_view fill = i / kColours.size() % 2 == 0 ? colour : "#FFFFFF";
    const double r = radius, s = 0.85 * radius;
    switch (i % kColours.size()) {
        case 0:
            page.circle(centre, s, fill, colour, 1.5);
            return;
        case 1:
            page.polygon(corners(centre, 1.2 * r, 4, 0.5), fill, colour, 1.5);
            return;
        case 2:
            page.polygon(corners(centre, 1.25 * r, 3, 0), fill, colour, 1.5);
            return;
        case 3:
            page.polygon(corners(centre, 1.25 * r, 4, 0), fill, colour, 1.5);
            return;
        case 4:
            page.polygon(corners(centre, 1.25 * r, 3, 1.5), fill, colour, 1.5);
            return;
        case 5:
            page.polygon(corners(centre, r, 6, 0), fill, colour, 1.5);
            return;
        case 6:
            page.polygon(corners(centre, 1.5 * r, 10, 0, 0.45), fill, colour, 1);
            return;
        default:
            page.polygon(corners(centre, 1.5 * r, 8, 0, 0.4), fill, colour, 1);
            return;
    }
}

void draw_cross(SvgPage& page, PagePoint c, double r, std::string_view colour) {
    page.line({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, 2.5);
    page.line({c.x - r, c.y + r}, {c.x + r, c.y - r}, colour, 2.5);
}

}  // namespace ember
