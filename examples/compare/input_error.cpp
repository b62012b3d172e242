#include "input_error.hpp"

namespace compare {

namespace {

// The length of the well-formed UTF-8 sequence at text[at], or 0.
std::size_t sequence_length(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const unsigned lead = byte(at);
    const std::size_t length = lead < 0x80U                     ? 1
                               : lead >= 0xc2U && lead <= 0xdfU ? 2
                               : lead >= 0xe0U && lead <= 0xefU ? 3
                               : lead >= 0xf0U && lead <= 0xf4U ? 4
                                                                : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xc0U) != 0x80U) {
            return 0;
        }
    }
    const unsigned second = length > 1 ? byte(at + 1) : 0;
    const bool overlong = (lead == 0xe0U && second < 0xa0U) || (lead == 0xf0U && second < 0x90U);
    const bool surrogate = lead == 0xedU && second > 0x9fU;
    const bool too_large = lead == 0xf4U && second > 0x8fU;
    const bool second_control = lead == 0xc2U && second < 0xa0U; // U+0080 to U+009F
    return overlong || surrogate || too_large || second_control ? 0 : length;
}

} // namespace

std::size_t formatting_at(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    if (byte(at) == 0xd8U) {
        return byte(at + 1) == 0x9cU ? 2 : 0; // U+061C
    }
    if (byte(at) == 0xefU) {
        return byte(at + 1) == 0xbbU && byte(at + 2) == 0xbfU ? 3 : 0; // U+FEFF
    }
    if (byte(at) != 0xe2U) {
        return 0;
    }
    const unsigned last = byte(at + 2);
    const bool general = byte(at + 1) == 0x80U && ((last >= 0x8bU && last <= 0x8fU) || // U+200B to U+200F
                                                   (last >= 0xa8U && last <= 0xaeU));  // U+2028 to U+202E
    const bool isolate = byte(at + 1) == 0x81U && last >= 0xa0U && last <= 0xafU;      // U+2060 to U+206F
    return general || isolate ? 3 : 0;
}

std::string printable(const std::string& text, std::size_t longest) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequence_length(text, at);
        const auto byte = static_cast<unsigned char>(text[at]);
        const bool plain =
            formatting_at(text, at) == 0 && (length > 1 || (length == 1 && byte >= 0x20U && byte != 0x7fU));
        if (result.size() + (plain ? length : 4) > longest) {
            return result + "...";
        }
        if (plain) {
            result.append(text, at, length);
            at += length;
        } else {
            result += {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
            ++at;
        }
    }
    return result;
}

std::string one_line(std::string message) {
    for (char& c : message) {
        c = c == '\n' ? ' ' : c;
    }
    return printable(message, 300);
}

} // namespace compare
