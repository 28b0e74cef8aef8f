#pragma once

#include "ui/document/document.h"
#include "ui/preview/preview_scheduler.h"
#include "ui/timeline/player.h"
#include "ui/viewport/split_view.h"
#include "ui/viewport/overlays.h"
#include "ui/viewport/solo_line.h"
#include "ui/viewport/readout.h"
#include "ui/viewport/surface.h"
#include "ui/viewport/viewport_input.h"
#include "ui/viewport/work_line.h"

#include <QWidget>

namespace fumage::ui {

/// The smoke, live: shows the pictures of the document at the player's frame, with what lies over them, and lends the
/// hand its surface.
class Viewport : public QWidget {
    Q_OBJECT

public:
    /// @param shelf for the air of what is shown
    Viewport(Document& document, Solo& solo, Player& player, std::shared_ptr<AirCache> shelf, GlSupport support,
        QWidget* parent = nullptr);

    /// What is on the screen; null before the first picture.
    [[nodiscard]] const PicturePtr& picture() const { return m_feed.picture(); }
    /// The air of what is shown, as far as it is baked.
    [[nodiscard]] const std::shared_ptr<AirCache>& shelf() const { return m_feed.shelf(); }
    /// Whether that is all there is to show of the document at this frame: nothing was given up, nothing is on its way.
    [[nodiscard]] bool isSettled() const { return m_feed.isSettled(); }
    /// Frames whose pictures are kept, for the timeline.
    [[nodiscard]] QList<int> cachedFrames() const { return m_feed.cachedFrames(); }
    [[nodiscard]] View view() const; ///< in logical pixels, as the mouse sees it
    [[nodiscard]] QWidget* surface() const { return m_surface->widget(); }

    [[nodiscard]] Overlays overlays() const { return m_overlays; }
    void setOverlay(Overlay overlay, bool on);
    /// Shows the smoke and nothing over it, whatever is switched on.
    void setBare(bool bare);
    [[nodiscard]] const Backdrop& backdrop() const { return m_feed.backdrop(); }
    void setBackdrop(const Backdrop& backdrop) { m_feed.setBackdrop(backdrop); }
    /// How much the pictures may take that are kept for playing.
    void setCacheBytes(qint64 bytes) { m_feed.setCacheBytes(bytes); }
    void setNavigationStyle(NavigationStyle style) { m_hand.setStyle(style); }
    [[nodiscard]] NavigationStyle navigationStyle() const { return m_hand.style(); }

    using Compare = fumage::ui::Compare;
    /// Shows another effect beside or instead of the document's.
    void setCompare(Compare compare, const Scene& other);
    [[nodiscard]] Compare compare() const { return m_split.mode(); }
    [[nodiscard]] const PicturePtr& otherPicture() const { return m_feed.otherPicture(); }

    void frameAll();
    void lookFrom(float yaw, float pitch);
    /// As the preset has it.
    void resetCamera();
    /// What is on the screen, without what lies over it where the picture is made by the processor.
    [[nodiscard]] QImage shownPicture();

    QSize minimumSizeHint() const override { return {240, 180}; }
    QSize sizeHint() const override { return {900, 700}; }

signals:
    void pictureShown(fumage::ui::PicturePtr picture);
    void cacheChanged();
    /// Pictures that were kept are kept no longer.
    void dropped();
    /// There was not enough memory for a picture.
    void exhausted();
    /// The air is being baked. @param share that is done; 1 when it is, or was given up
    void baking(double share);
    /// No pictures: the air does not hold what the effect asks for, or the like.
    void failed(const QString& why);
    /// The right button was clicked, or the key for menus pressed. @param global place on the screen
    void menuRequested(QPoint global);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void startAnew();
    void followDocument(const EffectChange& change);
    void followSize();
    void followWork(Phase phase, double share);
    void stopWork();
    void placeLines();
    void followVisibility();
    void display(const PicturePtr& picture);
    void paintOverlays(QPainter& painter);
    /// Edits the layer whose outline or smoke is seen at a place.
    void click(QPointF at, Qt::KeyboardModifiers modifiers);
    void choose(std::size_t layer);
    /// The layers whose emitters are outlined without being edited.
    [[nodiscard]] std::vector<std::size_t> otherLayers() const;
    /// The scene with the emitters of those where they are at the time that is shown.
    [[nodiscard]] Scene sceneNow() const;

    Document& m_document;
    const Solo& m_solo;
    Player& m_player;
    PreviewScheduler m_feed;
    Overlays m_overlays = Overlay::Grid | Overlay::Emitter | Overlay::Gizmos | Overlay::Readout;
    bool m_isBare = false;
    SplitView m_split;
    Readout m_readout;
    std::unique_ptr<Surface> m_surface;
    ViewportInput m_hand; ///< after the surface, which it holds
    WorkLine* m_workLine;
    SoloLine* m_soloLine;
    bool m_picksMore = false; ///< what is clicked is chosen beside what is
};

} // namespace fumage::ui
