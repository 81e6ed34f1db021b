// The few SVG elements that charts are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ember {

/// A place on the page [px], y downwards.
struct PagePoint {
    double x = 0, y = 0;
};

enum class TextAnchor { Start, Middle, End };

struct TextStyle {
    double size = 14;  // [px]
    TextAnchor anchor = TextAnchor::Start;
    bool bold = false;
    double turn = 0;  // [deg] clockwise
    std::string_view colour = "#222222";
};

/// Collects elements; svg() closes the document.
class SvgPage {
  public:
    /// A white page of width × height [px].
    SvgPage(double width, double height);

    void line(PagePoint from, PagePoint to, std::string_view colour, double width,
              std::string_view dashes = "");
    void polyline(const std::vector<PagePoint>& points, std::string_view colour, double width);
    /// A filled shape with an outline of `width`.
    void polygon(const std::vector<PagePoint>& points, std::string_view fill,
                 std::string_view outline, double width);
    void circle(PagePoint centre, double radius, std::string_view fill, std::string_view outline,
                double width);
    void rectangle(PagePoint corner, double width, double height, std::string_view fill,
                   double opacity = 1);
    void text(PagePoint at, std::string_view words, const TextStyle& style = {});

    [[nodiscard]] std::string svg() const;

  private:
    std::string body_;
    double width_, height_;
};

/// Colour and marker of series number `i`: neighbours differ in both.
[[nodiscard]] std::string_view series_colour(std::size_t i);

/// Draws the marker of series number `i`, about 2·radius wide [px].
void draw_marker(SvgPage& page, std::size_t i, PagePoint centre, double radius);

/// Draws a cross: a point that failed.
void draw_cross(SvgPage& page, PagePoint centre, double radius, std::string_view colour);

}  // namespace ember
