#pragma once

#include "ui/document/document.h"

#include <vector>

namespace fumage::ui {

// What is done to markers: each is one undo step.

/// Puts a marker at the time that is shown, with a name that none has yet. Nothing happens where one is there, or where
/// there are kMaxMarkers.
void addMarkerHere(Document& document);
/// Gives a marker another name, as markerNameOf() makes it; an empty one changes nothing.
/// @param marker below their number
void renameMarker(Document& document, std::size_t marker, const QString& name);
/// @param marker below their number
void removeMarker(Document& document, std::size_t marker);

/// Sets other markers in place of all.
/// @param text of the undo step
void replaceMarkers(Document& document, const std::vector<Marker>& markers, const QString& text, Gesture gesture = {});
/// Markers of which one lies at another time, brought between 0 and kMaxMarkerSeconds.
/// @param marker below their number
[[nodiscard]] std::vector<Marker> withMovedMarker(std::vector<Marker> markers, std::size_t marker, double seconds);

/// Times of all markers, in order.
[[nodiscard]] std::vector<double> markerTimes(const Document& document);

} // namespace fumage::ui
