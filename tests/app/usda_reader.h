// A small reader of USD text files, independent of the writer: enough to see that the structure is
// right and to read numbers back.
#pragma once

#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace ember {

/// A value per time code, as flat numbers; constant values are at time -1.
struct UsdaAttribute {
    std::string type, interpolation;
    std::map<double, std::vector<double>> samples;
};

struct UsdaPrim {
    std::string type;
    std::map<std::string, UsdaAttribute> attributes;
    std::map<std::string, UsdaPrim> children;
};

struct UsdaStage {
    std::map<std::string, std::string> metadata;
    std::map<std::string, UsdaPrim> prims;
};

class UsdaReader {
  public:
    explicit UsdaReader(const std::string& text) : text_(text) {}

    UsdaStage read() {
        UsdaStage stage;
        expect("#usda");
        expect("1.0");
        expect("(");
        while (!take(")")) {
            const std::string key = word();
            expect("=");
            stage.metadata[key] = word();
        }
        while (more())
            read_prim(stage.prims);
        return stage;
    }

  private:
    bool more() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
        return at_ < text_.size();
    }

    // A name, a number, a quoted text, or one mark.
    std::string word() {
        if (!more()) throw std::runtime_error("the file ends too early");
        const std::size_t start = at_;
        if (text_[at_] == '"') {
            do {
                at_ = text_.find('"', at_ + 1);
            } while (at_ != std::string::npos && text_[at_ - 1] == '\\');
            if (at_ == std::string::npos) throw std::runtime_error("a text does not end");
            ++at_;
            return text_.substr(start + 1, at_ - start - 2);
        }
        if (std::string("(){}[],=").find(text_[at_]) != std::string::npos) {
            return text_.substr(at_++, 1);
        }
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) == 0 &&
               std::string("(){},=").find(text_[at_]) == std::string::npos)
            ++at_;
        return text_.substr(start, at_ - start);
    }

    bool take(const std::string& wanted) {
        const std::size_t before = at_;
        if (word() == wanted) return true;
        at_ = before;
        return false;
    }

    void expect(const std::string& wanted) {
        const std::string got = word();
        if (got != wanted) throw std::runtime_error("expected " + wanted + ", got " + got);
    }

    void read_prim(std::map<std::string, UsdaPrim>& prims) {
        expect("def");
        const std::string type = word(), name = word();
        UsdaPrim& prim = prims[name];
        prim.type = type;
        expect("{");
        while (!take("}")) {
            const std::size_t before = at_;
            if (take("def")) {
                at_ = before;
                read_prim(prim.children);
            } else {
                read_attribute(prim);
            }
        }
    }

    void read_attribute(UsdaPrim& prim) {
        std::string type = word();
        if (type == "uniform") type = word();
        std::string name = word();
        const std::string ending = ".timeSamples";
        const bool moving = name.ends_with(ending);
        if (moving) name.resize(name.size() - ending.size());
        UsdaAttribute& attribute = prim.attributes[name];
        attribute.type = type;
        if (take("(")) return read_metadata(attribute);
        expect("=");
        if (!moving) {
            attribute.samples[-1] = value();
            if (take("(")) read_metadata(attribute);
            return;
        }
        expect("{");
        while (!take("}")) {
            std::string time = word();
            if (time.back() != ':') throw std::runtime_error("expected a time, got " + time);
            time.pop_back();
            attribute.samples[std::stod(time)] = value();
            expect(",");
        }
    }

    void read_metadata(UsdaAttribute& attribute) {
        expect("interpolation");
        expect("=");
        attribute.interpolation = word();
        expect(")");
    }

    // A number, a text (as nothing), or any nesting of () and [].
    std::vector<double> value() {
        std::vector<double> numbers;
        int depth = 0;
        do {
            std::string text = word();
            while (text.size() > 1 && text.back() == ']') {  // "4]" without a space
                text.pop_back();
                at_ -= 1;
            }
            if (text == "[" || text == "(") {
                ++depth;
            } else if (text == "]" || text == ")") {
                --depth;
            } else if (text != "," &&
                       (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || text[0] == '-')) {
                numbers.push_back(std::stod(text));
            }
        } while (depth > 0);
        return numbers;
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

inline UsdaStage read_usda(const std::string& text) {
    return UsdaReader(text).read();
}

}  // namespace ember
