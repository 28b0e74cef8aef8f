#include "ui/document/marker_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace fumage::ui {

namespace {

/// The texts of undo steps, and names of new markers.
struct MarkerEdits {
    Q_DECLARE_TR_FUNCTIONS(MarkerEdits)
};

/// "Marker 3": the first that none has.
std::string newName(const std::vector<Marker>& markers)
{
    for (std::size_t number = 1;; ++number) {
        std::string name = markerNameOf(MarkerEdits::tr("Marker %1").arg(number).toStdString());
        if (std::ranges::find(markers, name, &Marker::name) == markers.end()) {
            return name;
        }
    }
}

} // namespace

void addMarkerHere(Document& document)
{
    std::vector<Marker> markers = document.scene().markers;
    const bool isNew =
        std::ranges::none_of(markers, [&](const Marker& each) { return each.seconds == document.seconds(); });
    if (isNew && markers.size() < kMaxMarkers) {
        addMarker(markers, {newName(markers), document.seconds()});
        replaceMarkers(document, markers, MarkerEdits::tr("Add a marker"));
    }
}

void renameMarker(Document& document, std::size_t marker, const QString& name)
{
    std::vector<Marker> markers = document.scene().markers;
    markers[marker].name = markerNameOf(name.toStdString());
    if (!markers[marker].name.empty()) {
        replaceMarkers(document, markers, MarkerEdits::tr("Rename a marker"));
    }
}

void removeMarker(Document& document, std::size_t marker)
{
    std::vector<Marker> markers = document.scene().markers;
    markers.erase(markers.begin() + static_cast<std::ptrdiff_t>(marker));
    replaceMarkers(document, markers, MarkerEdits::tr("Remove a marker"));
}

void replaceMarkers(Document& document, const std::vector<Marker>& markers, const QString& text, Gesture gesture)
{
    Scene scene = document.scene();
    scene.markers = markers;
    document.replaceScene(scene, document.selection(), text, gesture);
}

std::vector<Marker> withMovedMarker(std::vector<Marker> markers, std::size_t marker, double seconds)
{
    Marker moved = markers[marker];
    markers.erase(markers.begin() + static_cast<std::ptrdiff_t>(marker));
    moved.seconds = std::clamp(seconds, 0.0, kMaxMarkerSeconds);
    addMarker(markers, std::move(moved));
    return markers;
}

std::vector<double> markerTimes(const Document& document)
{
    std::vector<double> times;
    for (const Marker& marker : document.scene().markers) {
        times.push_back(marker.seconds);
    }
    return times;
}

} // namespace fumage::ui
