#pragma once

#include "ui/document/document.h"
#include "ui/face/hand.h"
#include "ui/pictures/picture_feed.h"
#include "ui/timeline/player.h"
#include "ui/viewport/gizmos.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/overlays.h"
#include "ui/viewport/surface.h"

#include <QElapsedTimer>
#include <QWidget>

namespace fumage::ui {

/// The smoke, live: shows the pictures of the document at the player's frame, and turns the mouse into camera moves and gizmo drags.
class Viewport : public QWidget {
    Q_OBJECT

public:
    Viewport(Document& document, Player& player, GlSupport support, QWidget* parent = nullptr);
    ~Viewport() override;

    /// What is on the screen; null before the first picture.
    [[nodiscard]] const PicturePtr& picture() const { return m_feed.picture(); }
    /// Whether that is all there is to show of the document at this frame: nothing was given up, nothing is on its way.
    [[nodiscard]] bool isSettled() const { return m_feed.isSettled(); }
    /// Frames whose pictures are kept, for the timeline.
    [[nodiscard]] QList<int> cachedFrames() const { return m_feed.cachedFrames(); }
    [[nodiscard]] View view() const; ///< in logical pixels, as the mouse sees it
    [[nodiscard]] QWidget* surface() const { return m_surface->widget(); }

    [[nodiscard]] Overlays overlays() const { return m_overlays; }
    void setOverlay(Overlay overlay, bool on);
    [[nodiscard]] const Backdrop& backdrop() const { return m_feed.backdrop(); }
    void setBackdrop(const Backdrop& backdrop) { m_feed.setBackdrop(backdrop); }
    void setNavigationStyle(NavigationStyle style) { m_style = style; }
    [[nodiscard]] NavigationStyle navigationStyle() const { return m_style; }

    /// Shows another effect beside or instead of the document's.
    enum class Compare {
        Off,
        Split, ///< B to the right of a line that can be dragged
        Other, ///< B alone
    };
    void setCompare(Compare compare, const Effect& other);
    [[nodiscard]] Compare compare() const { return m_compare; }
    [[nodiscard]] const PicturePtr& otherPicture() const { return m_feed.otherPicture(); }

    void frameAll();
    void lookFrom(float yaw, float pitch);

    QSize minimumSizeHint() const override { return {240, 180}; }
    QSize sizeHint() const override { return {900, 700}; }

signals:
    void pictureShown(fumage::ui::PicturePtr picture);
    void cacheChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Drag {
        std::optional<GizmoId> gizmo;
        std::optional<CameraMove> move;
        bool divider = false;
        QPointF start;
        Effect before;
        View view;
        Gesture gesture;
    };

    void followDocument(const EffectChange& change);
    void followSize();
    void followVisibility();
    void display(const PicturePtr& picture);

    void press(QMouseEvent& event);
    void move(QMouseEvent& event);
    void release();
    void wheel(QWheelEvent& event);
    void setHot(std::optional<GizmoId> gizmo);
    void applyCamera(const Camera& camera, const QString& text, Gesture gesture);
    [[nodiscard]] double dividerX() const;

    void paintOverlay(QPainter& painter);
    void paintOther(QPainter& painter);
    void paintReadout(QPainter& painter) const;

    Document& m_document;
    Player& m_player;
    std::unique_ptr<Surface> m_surface;
    PictureFeed m_feed;
    Burst m_wheelBurst;
    Gesture m_wheelGesture;

    Overlays m_overlays = Overlay::Grid | Overlay::Emitter | Overlay::Gizmos | Overlay::Readout;
    NavigationStyle m_style = NavigationStyle::Blender;
    std::optional<Drag> m_drag;
    std::optional<GizmoId> m_hot;
    Compare m_compare = Compare::Off;
    double m_divider = 0.5; ///< share of the width

    QElapsedTimer m_sinceShown;
    double m_frameMs = 0.0; ///< between pictures, smoothed
};

} // namespace fumage::ui
