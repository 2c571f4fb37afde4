// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/text.h"

#include <cmath>
#include <filesystem>
#include <format>

namespace s2b::report
{
namespace
{

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::string_view kNarrowSpace = "\xE2\x80\xAF";
constexpr std::string_view kMinus = "\xE2\x88\x92";

/// Length of the UTF-8 sequence that starts here, 0 when it is none (RFC 3629: no overlong form, no surrogate).
std::size_t sequenceLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned first = byte(0);
    if (first < 0x80)
        return 1;
    if (first >= 0xC2 && first <= 0xDF && continues(1))
        return 2;
    const bool isThree = first >= 0xE0 && first <= 0xEF && continues(1) && continues(2);
    if (isThree && !(first == 0xE0 && byte(1) < 0xA0) && !(first == 0xED && byte(1) >= 0xA0))
        return 3;
    const bool isFour = first >= 0xF0 && first <= 0xF4 && continues(1) && continues(2) && continues(3);
    if (isFour && !(first == 0xF0 && byte(1) < 0x90) && !(first == 0xF4 && byte(1) >= 0x90))
        return 4;
    return 0;
}

/// Fixed decimals with '.', "-0.0" made "0.0".
std::string fixed(double value, int decimals)
{
    std::string text = std::format("{:.{}f}", value, decimals);
    if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos)
        text.erase(0, 1);
    return text;
}

}  // namespace

std::string cleanText(std::string_view text)
{
    std::string clean;
    while (!text.empty())
    {
        const std::size_t length = sequenceLength(text);
        const auto first = static_cast<unsigned char>(text.front());
        if (length == 0)
            clean += kReplacement;
        else if (length == 1 && (first < 0x20 || first == 0x7F))
            clean += ' ';
        else
            clean += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return clean;
}

std::string escapeXml(std::string_view text)
{
    std::string escaped;
    for (const char c : text)
    {
        switch (c)
        {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string plainNumber(double value, int decimals)
{
    std::string text = fixed(value, decimals);
    if (text.find('.') != std::string::npos)
    {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
    }
    return text;
}

std::string number(double value, int decimals)
{
    if (!std::isfinite(value))
        return kNone;
    std::string text = fixed(value, decimals);
    if (text.front() == '-')
        text.replace(0, 1, kMinus);
    return text;
}

std::string number(const std::optional<double>& value, int decimals)
{
    return value ? number(*value, decimals) : kNone;
}

std::string counted(std::uint64_t count)
{
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i)
    {
        if (i > 0 && (digits.size() - i) % 3 == 0)
            text += kNarrowSpace;
        text += digits[i];
    }
    return text;
}

std::string millimetres(double length_m, bool sign)
{
    const double length_mm = 1000.0 * length_m;
    const std::string text = number(length_mm, std::abs(length_mm) < 99.95 ? 1 : 0);
    const bool isGain = sign && std::isfinite(length_mm) &&
                        fixed(length_mm, 1).find_first_of("-") == std::string::npos && fixed(length_mm, 1) != "0.0";
    return isGain ? "+" + text : text;
}

std::string millimetres(const std::optional<double>& length_m, bool sign)
{
    return length_m ? millimetres(*length_m, sign) : kNone;
}

std::string roundMillimetres(double length_m, bool sign)
{
    std::string text = plainNumber(1000.0 * length_m, 2);
    if (text.front() == '-')
        text.replace(0, 1, kMinus);
    else if (sign && text != "0")
        text.insert(0, "+");
    return text;
}

std::string percent(double share)
{
    return number(100.0 * share, 0) + std::string(kNarrowSpace) + "%";
}

std::string fileName(std::string_view path)
{
    return cleanText(std::filesystem::path(path).filename().string());
}

std::string base64(std::string_view bytes)
{
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[bits >> (18U - 6U * k) & 63U];
    }
    return text;
}

}  // namespace s2b::report
