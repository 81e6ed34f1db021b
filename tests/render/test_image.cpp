// PNG files and differences between images.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/image.h"
#include "render/image_difference.h"
#include "tests/app/temporary_folder.h"

namespace ember {
namespace {

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int level : {x * 7, y * 11, x * y, 255 - x}) {
                image.rgba.push_back(static_cast<std::uint8_t>(level & 255));
            }
        }
    }
    return image;
}

std::string error_of(const auto& action) {
    try {
        action();
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

TEST(Png, PixelsComeBackAsTheyWere) {
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {37, 23}, {480, 3}}) {
        const Image image = gradient(width, height);
        write_png(folder / "a.png", image);
        const Image back = read_image(folder / "a.png");
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.rgba, image.rgba);
    }
    EXPECT_EQ(folder.files(), std::set<std::string>{"a.png"});
}

TEST(Png, TextChunksComeBackInOrderAndPixelsWithThem) {
    const TemporaryFolder folder;
    const ImageText text = {
        {"Software", "emberleaf test"}, {"Preset", "paper/corner"}, {"Comment", ""}};
    write_png(folder / "a.png", gradient(5, 4), text);
    EXPECT_EQ(read_png_text(folder / "a.png"), text);
    EXPECT_EQ(read_image(folder / "a.png").rgba, gradient(5, 4).rgba);
    write_png(folder / "b.png", gradient(5, 4));
    EXPECT_TRUE(read_png_text(folder / "b.png").empty());
}

// A chunk with a wrong checksum is an error to strict readers, though not to ours.
TEST(Png, ATextChunkStandsBeforeThePixelsWithItsChecksum) {
    const TemporaryFolder folder;
    write_png(folder / "a.png", gradient(2, 2), {{"Software", "emberleaf test"}});
    const std::string bytes = folder.read("a.png");
    const std::string data("tEXtSoftware\0emberleaf test", 27);
    const std::size_t at = bytes.find(data);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(bytes.substr(at - 4, 4), std::string("\0\0\0\x17", 4));  // 23 bytes
    EXPECT_EQ(bytes.substr(at + 27, 4), "\xbd\xe9\x45\xd8");           // CRC-32, by zlib
    EXPECT_LT(at, bytes.find("IDAT"));
    EXPECT_GT(at, bytes.find("IHDR"));
}

TEST(Png, AnUnwritablePathIsNamedAndNothingIsLeftBehind) {
    const TemporaryFolder folder;
    folder.write("file", "in the way");
    const std::string error = error_of([&] { write_png(folder / "file/a.png", gradient(2, 2)); });
    EXPECT_NE(error.find((folder / "file").string()), std::string::npos) << error;
    EXPECT_NE(error.find("Not a directory"), std::string::npos) << error;
    EXPECT_EQ(folder.files(), std::set<std::string>{"file"});

    folder.write("a.png/occupied", "");  // a folder stands where the file should go
    EXPECT_NE(error_of([&] { write_png(folder / "a.png", gradient(2, 2)); }), "no error");
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.png", "a.png/occupied", "file"}));
}

TEST(Png, AnImageWithoutItsPixelsIsRefused) {
    const TemporaryFolder folder;
    Image image = gradient(4, 4);
    image.rgba.pop_back();
    EXPECT_NE(error_of([&] { write_png(folder / "a.png", image); }), "no error");
    EXPECT_NE(error_of([&] { write_png(folder / "a.png", Image{}); }), "no error");
    EXPECT_TRUE(folder.files().empty());
}

TEST(Png, FilesThatAreNoImageAreNamed) {
    const TemporaryFolder folder;
    folder.write("text.png", "no image");
    write_png(folder / "whole.png", gradient(64, 64));
    const std::string whole = folder.read("whole.png");
    folder.write("half.png", whole.substr(0, whole.size() / 2));
    for (const char* name : {"text.png", "half.png", "missing.png"}) {
        const std::string error = error_of([&] { (void)read_image(folder / name); });
        EXPECT_NE(error.find(name), std::string::npos) << error;
    }
}

TEST(Png, AChunkLongerThanTheFileIsAnErrorAndNotReadBeyondItsEnd) {
    const TemporaryFolder folder;
    write_png(folder / "a.png", gradient(2, 2), {{"Software", "emberleaf test"}});
    std::string bytes = folder.read("a.png");
    bytes[bytes.find("tEXt") - 4] = '\x7f';
    folder.write("a.png", bytes);
    EXPECT_NE(error_of([&] { (void)read_png_text(folder / "a.png"); }), "no error");
}

TEST(ImageDifference, CountsPixelsAndFindsTheLargestStep) {
    const Image a = gradient(8, 6);
    Image b = a;
    EXPECT_TRUE(compare(a, b).identical());
    b.rgba[4] = static_cast<std::uint8_t>(b.rgba[4] + 3);
    b.rgba[5] = static_cast<std::uint8_t>(b.rgba[5] + 9);
    b.rgba[47] = static_cast<std::uint8_t>(b.rgba[47] - 1);  // an alpha counts too
    const ImageDifference d = compare(a, b);
    EXPECT_TRUE(d.comparable);
    EXPECT_FALSE(d.identical());
    EXPECT_EQ(d.max_difference, 9);
    EXPECT_EQ(d.pixels, 2);
    EXPECT_EQ(compare(b, a).max_difference, 9);
}

TEST(ImageDifference, OtherSizesCannotBeCompared) {
    EXPECT_FALSE(compare(gradient(4, 6), gradient(6, 4)).comparable);
    EXPECT_FALSE(compare(gradient(4, 6), gradient(6, 4)).identical());
}

TEST(ImageDifference, ItsPictureIsAmplifiedClampedAndOpaque) {
    const Image a = gradient(3, 1);
    Image b = a;
    b.rgba[0] = static_cast<std::uint8_t>(b.rgba[0] + 2);
    b.rgba[4] = static_cast<std::uint8_t>(b.rgba[4] + 100);
    const Image picture = difference_image(a, b, 16);
    EXPECT_EQ(picture.rgba,
              (std::vector<std::uint8_t>{32, 0, 0, 255, 255, 0, 0, 255, 0, 0, 0, 255}));
}

}  // namespace
}  // namespace ember
