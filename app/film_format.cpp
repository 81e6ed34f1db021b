#include "app/film_format.h"

#include <iterator>
#include <sstream>

#include "app/preset_io/parameter_value.h"

namespace ember {
namespace {

constexpr FilmFormat kFilms[] = {
    // yuv420p, which any player knows, shares colour between 2x2 pixels, so both sizes must be even
    {".mp4", false,
     "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p -c:v libx264 -crf 18 "
     "-movflags +faststart -f mp4"},
    // ProRes 4444 for editors
    {".mov", true,
     "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2:color=black@0 -c:v prores_ks -profile:v 4444 "
     "-pix_fmt yuva444p10le -f mov"},
    {".webm", true,
     "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2:color=black@0 -c:v libvpx-vp9 -pix_fmt yuva420p -crf 24 "
     "-b:v 0 -deadline good -cpu-used 4 -row-mt 1 -f webm"},
    {".gif", true,
     "-filter_complex split[a][b];[a]palettegen=reserve_transparent=1[p];[b][p]paletteuse "
     "-loop 0 -f gif"},
    {".webp", true, "-c:v libwebp_anim -quality 85 -loop 0 -f webp"},
    {".apng", true, "-plays 0 -f apng"},
    // every bit, for further work
    {".mkv", true, "-c:v ffv1 -pix_fmt bgra -f matroska"},
};

}  // namespace

const FilmFormat* find_film_format(std::string_view extension) {
    for (const FilmFormat& film : kFilms) {
        if (film.extension == extension) return &film;
    }
    return nullptr;
}

std::string film_extensions() {
    std::string text;
    for (std::size_t i = 0; i < std::size(kFilms); ++i)
        text += (i + 1 < std::size(kFilms) ? ", " : " or ") + std::string(kFilms[i].extension);
    return text;
}

std::vector<std::string> ffmpeg_command(const FilmFormat& film, const PictureFormat& format,
                                        const std::string& output) {
    std::vector<std::string> command = {
        "ffmpeg",
        "-hide_banner",
        "-loglevel",
        "error",
        "-y",
        "-f",
        "rawvideo",
        "-pixel_format",
        "rgba",
        "-video_size",
        std::to_string(format.width) + 'x' + std::to_string(format.height),
        "-framerate",
        number_text(format.fps),
        "-i",
        "-"};
    std::istringstream words{std::string(film.arguments)};
    for (std::string word; words >> word;)
        command.push_back(word);
    command.push_back(output);
    return command;
}

}  // namespace ember
