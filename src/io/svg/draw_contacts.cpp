#include <algorithm>
#include <array>
#include <optional>

#include "io/svg/draw.hpp"

namespace osculo::io::svg {
namespace {

constexpr std::size_t kMostDots = 1'000;
constexpr std::size_t kMostNumbers = 40;
constexpr double kTextSize = 11;
constexpr double kApart = 1;  // [px], what labels keep free around them

// A rectangle in pixels that is taken.
struct Taken {
    double left, top, right, bottom;
    [[nodiscard]] bool overlaps(const Taken& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// The place of a label next to its contact, at the first of some spots that is free.
std::optional<Taken> free_place(Point contact, std::size_t characters, const View& view,
                                const std::vector<Taken>& taken) {
    constexpr double kHeight = 0.75 * kTextSize;
    const double width = 0.7 * kTextSize * static_cast<double>(characters);
    constexpr std::array<Point, 8> kDirections{
        {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};
    for (const double distance : {4.0, 9.0, 15.0, 22.0}) {
        for (const Point& direction : kDirections) {
            const double x = contact.x + direction.x * (distance + width / 2);
            const double y = contact.y + direction.y * (distance + kHeight / 2);
            const Taken place{x - width / 2 - kApart, y - kHeight / 2 - kApart,
                              x + width / 2 + kApart, y + kHeight / 2 + kApart};
            const bool is_free =
                view.shows({place.left, place.top}) && view.shows({place.right, place.bottom}) &&
                std::ranges::none_of(taken, [&](const Taken& t) { return t.overlaps(place); });
            if (is_free) return place;
        }
    }
    return std::nullopt;
}

}  // namespace

DrawnContacts draw_contacts(Canvas& canvas, const Picture& picture, const Run& run, bool numbers) {
    DrawnContacts drawn;
    drawn.dots = run.events.size() <= kMostDots ? run.events.size() : kMostNumbers;
    drawn.numbered = numbers ? std::min(run.events.size(), kMostNumbers) : 0;

    std::vector<Taken> taken;
    canvas.raw("<g fill=\"" + std::string(picture.look.contact) + "\" stroke=\"" +
               std::string(picture.look.contact_halo) + "\" stroke-width=\"0.6\">\n");
    for (std::size_t i = 0; i < drawn.dots; ++i) {
        const Point at = picture.view(run.events[i].point);
        if (!picture.view.shows(at)) continue;
        const bool is_numbered = i < drawn.numbered;
        canvas.circle(at, is_numbered ? 2.4 : 1.5, is_numbered ? "" : "fill-opacity=\"0.6\"");
        if (is_numbered) taken.push_back({at.x - 3, at.y - 3, at.x + 3, at.y + 3});
    }
    canvas.raw("</g>\n");

    canvas.raw("<g font-weight=\"bold\" text-anchor=\"middle\" paint-order=\"stroke\" stroke=\"" +
               std::string(picture.look.contact_halo) +
               "\" stroke-width=\"2.5\" stroke-linejoin=\"round\" fill=\"" +
               std::string(picture.look.contact_text) + "\">\n");
    for (std::size_t i = 0; i < drawn.numbered; ++i) {
        const std::string label = std::to_string(i + 1);
        const Point at = picture.view(run.events[i].point);
        const auto place = free_place(at, label.size(), picture.view, taken);
        if (!place) {
            ++drawn.skipped;
            continue;
        }
        taken.push_back(*place);
        canvas.text({(place->left + place->right) / 2, place->bottom - kApart}, kTextSize, label,
                    "");
    }
    canvas.raw("</g>\n");
    return drawn;
}

}  // namespace osculo::io::svg
