#pragma once

#include "ui/document/document.h"
#include "ui/face/hand.h"
#include "ui/viewport/split_view.h"
#include "ui/viewport/gizmos.h"
#include "ui/viewport/navigation.h"

#include <QObject>

#include <functional>
#include <optional>
#include <variant>

namespace fumage::ui {

/// The mouse over the picture: what it grips, drags and turns becomes edits of the document.
class ViewportHand : public QObject {
    Q_OBJECT

public:
    /// @param surface that is touched; its events are taken from it
    /// @param view    of the surface as it is now, in logical pixels
    ViewportHand(Document& document, SplitView& split, QWidget& surface, std::function<View()> view, QObject* parent = nullptr);

    [[nodiscard]] NavigationStyle style() const { return m_style; }
    void setStyle(NavigationStyle style) { m_style = style; }
    /// Whether gizmos are there to be gripped.
    void setGizmos(bool shown) { m_gizmos = shown; }
    /// The gizmo that is dragged, or else the one under the mouse.
    [[nodiscard]] std::optional<GizmoId> gizmo() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct DividingLine { };
    using Grip = std::variant<DividingLine, GizmoId, CameraMove>;
    struct Drag {
        Grip grip;
        QPointF start;
        Effect before;
        View view;
        Gesture gesture;
    };

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    [[nodiscard]] std::optional<Grip> gripFor(const QMouseEvent& event) const;
    void drag(DividingLine line, const QMouseEvent& event);
    void drag(GizmoId gizmo, const QMouseEvent& event);
    void drag(CameraMove move, const QMouseEvent& event);
    void setHot(std::optional<GizmoId> gizmo);

    Document& m_document;
    SplitView& m_split;
    QWidget& m_surface;
    std::function<View()> m_view;
    NavigationStyle m_style = NavigationStyle::Blender;
    bool m_gizmos = true;
    std::optional<Drag> m_drag;
    std::optional<GizmoId> m_hot; ///< under the mouse
    Burst m_wheelBurst;
    Gesture m_wheelGesture;
};

} // namespace fumage::ui
