#include "app/difference_report.h"

#include <array>
#include <cstdio>
#include <string_view>

#include "app/xml_text.h"

namespace ember {
namespace {

constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>@</title><style>
body{background:#161618;color:#ddd;font:15px/1.5 sans-serif;margin:2em}
h1{font-size:1.4em} h2{font-size:1.1em;margin:2.5em 0 .3em;color:#f0a060}
pre{background:#222;padding:.7em;white-space:pre-wrap}
figure{display:inline-block;margin:0 1em 1em 0} figcaption{color:#999}
img{image-rendering:pixelated;min-width:240px;background:#000;display:block}
.swap{position:relative} .swap img+img{position:absolute;top:0;left:0;opacity:0}
.swap:hover img+img{opacity:1}
td{padding:0 1.2em .1em 0;vertical-align:top} td:first-child{color:#999;white-space:nowrap}
</style></head><body><h1>@</h1>
)";

std::string base64(std::string_view bytes) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
    }
    return out;
}

std::string image_tag(const Image& image) {
    return "<img alt=\"\" src=\"data:image/png;base64," + base64(encode_png(image)) + "\">";
}

std::string figure(const std::string& caption, const std::string& images) {
    return "<figure><div class=\"swap\">" + images + "</div><figcaption>" + xml_escaped(caption) +
           "</figcaption></figure>\n";
}

std::string row(const std::string& name, const std::string& value) {
    return "<tr><td>" + xml_escaped(name) + "</td><td>" + xml_escaped(value) + "</td></tr>\n";
}

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
    std::array<char, 160> out{};
    std::snprintf(out.data(), out.size(), format, numbers...);
    return out.data();
}

std::string figures_of(const ImageDifference& d) {
    const auto count = [](std::int64_t n) { return static_cast<long long>(n); };
    return row("pixels that differ",
               text("%lld of %lld (%.4g %%)", count(d.pixels), count(d.total), d.percent_over(0))) +
           row("by more than 2 levels",
               text("%lld (%.4g %%)", count(d.pixels_over(2)), d.percent_over(2))) +
           row("largest difference",
               text("%d levels, at pixel %d,%d", d.max_difference, d.max_x, d.max_y)) +
           row("worst block of 16x16", text("%.4g levels on average, at pixel %d,%d", d.worst_block,
                                            d.block_x, d.block_y)) +
           row("mean, RMS", text("%.4g, %.4g levels; PSNR %.4g dB", d.mean, d.rms, d.psnr()));
}

std::string pictures_of(const ReportEntry& entry, const ImageDifference& d) {
    std::string out;
    if (entry.expected)
        out += figure(entry.actual ? "expected; drawn below the mouse" : "expected",
                      image_tag(*entry.expected) + (entry.actual ? image_tag(*entry.actual) : ""));
    if (entry.actual) out += figure("drawn", image_tag(*entry.actual));
    if (!entry.expected || !entry.actual || !d.comparable) return out;
    out += figure("difference, 16 times",
                  image_tag(difference_image(*entry.expected, *entry.actual, 16)));
    out += figure("heat map: black none, white 255 levels, each doubling a step",
                  image_tag(heat_image(*entry.expected, *entry.actual)));
    return out;
}

}  // namespace

std::string difference_report(const std::string& title, std::span<const ReportEntry> entries) {
    std::string out;
    for (const char c : kHead)
        out += c == '@' ? xml_escaped(title) : std::string(1, c);
    for (const ReportEntry& entry : entries) {
        ImageDifference d;
        if (entry.expected && entry.actual) d = compare(*entry.expected, *entry.actual);
        out += "<h2>" + xml_escaped(entry.name) + "</h2>\n<pre>" + xml_escaped(entry.verdict) +
               "</pre>\n";
        out += pictures_of(entry, d) + "<table>\n";
        if (d.comparable) out += figures_of(d);
        for (const auto& [name, value] : entry.facts)
            out += row(name, value);
        out += "</table>\n";
    }
    return out + "</body></html>\n";
}

}  // namespace ember
