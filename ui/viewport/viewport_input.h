#pragma once

#include "ui/document/document.h"
#include "ui/widgets/gesture.h"
#include "ui/viewport/split_view.h"
#include "ui/viewport/gizmos.h"
#include "ui/viewport/navigation.h"

#include <QObject>

#include <functional>
#include <optional>
#include <variant>

namespace fumage::ui {

/// The mouse over the picture: what it grips, drags and turns becomes edits of the document.
class ViewportInput : public QObject {
    Q_OBJECT

public:
    /// @param surface that is touched; its events are taken from it
    /// @param view    of the surface as it is now, in logical pixels
    ViewportInput(
        Document& document, SplitView& split, QWidget& surface, std::function<View()> view, QObject* parent = nullptr);

    [[nodiscard]] NavigationStyle style() const { return m_style; }
    void setStyle(NavigationStyle style) { m_style = style; }
    /// Whether gizmos are there to be gripped.
    void setGizmos(bool shown) { m_gizmos = shown; }
    /// The gizmo that is dragged, or else the one under the mouse.
    [[nodiscard]] std::optional<GizmoId> gizmo() const;
    /// Whether the mouse is over the picture, or drags something of it.
    [[nodiscard]] bool isNear() const { return m_isInside || m_drag.has_value(); }

signals:
    /// The right button was clicked without a drag, or the key for menus pressed.
    void menuRequested(QPoint global);
    /// The left button was clicked, without a drag, on nothing that can be gripped.
    void clicked(QPointF at, Qt::KeyboardModifiers modifiers);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct DividingLine { };
    /// The dot of a key frame of the emitter's way.
    struct WayKey {
        double seconds;
    };
    using Grip = std::variant<DividingLine, GizmoId, WayKey, CameraMove>;
    struct Drag {
        Grip grip;
        Qt::MouseButton button;
        EndlessWay way;
        Effect before;
        Scene scene; ///< before
        View view;
        Gesture gesture;
        bool isClick = false; ///< as long as the mouse stays where the left button was pressed
    };

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    /// Everything that the drag has changed is as it was.
    void takeBack();
    void wheel(const QWheelEvent& event);
    [[nodiscard]] std::optional<Grip> gripFor(const QMouseEvent& event) const;
    void drag(DividingLine line, const QMouseEvent& event);
    void drag(GizmoId gizmo, const QMouseEvent& event);
    void drag(WayKey key, const QMouseEvent& event);
    /// The way of the emitter, where it has key frames that can be seen.
    [[nodiscard]] const Track* way() const;
    void drag(CameraMove move, const QMouseEvent& event);
    void setHot(std::optional<GizmoId> gizmo);
    void setInside(bool inside);

    Document& m_document;
    SplitView& m_split;
    QWidget& m_surface;
    std::function<View()> m_view;
    NavigationStyle m_style = NavigationStyle::Blender;
    bool m_gizmos = true;
    std::optional<Drag> m_drag;
    std::optional<GizmoId> m_hot; ///< under the mouse
    bool m_isInside = false; ///< the mouse is over the surface
    QPointF m_rightPress; ///< on the screen, of the right button
    GestureTimer m_wheelTimer;
    Gesture m_wheelGesture;
};

} // namespace fumage::ui
