#include "ui/preview/preview_scheduler.h"

#include <algorithm>

namespace fumage::ui {

namespace {

constexpr int kRestMs = 160;

} // namespace

PreviewScheduler::PreviewScheduler(std::shared_ptr<AirCache> shelf, qint64 cacheBytes, QObject* parent)
    : QObject(parent)
    , m_cache(cacheBytes)
    , m_shelf(std::move(shelf))
    , m_worker(m_shelf)
    , m_preparer(m_shelf)
{
    m_wanted.scene = std::make_shared<const Scene>();
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &PreviewScheduler::rest);
    connect(&m_worker, &PictureWorker::pictureReady, this, &PreviewScheduler::receive);
    connect(&m_worker, &PictureWorker::working, this, [this](Phase phase, double share) {
        if (!m_preparer.isBusy()) { // which is what keeps all of it waiting
            emit working(phase, share);
        }
    });
    connect(&m_preparer, &Preparer::working, this, &PreviewScheduler::working);
    connect(&m_preparer, &Preparer::ended, this, [this](bool succeeded) {
        m_wanted.mayBake = succeeded; // or it would be tried again and again
        emit working(Phase::Idle, 1.0);
    });
    connect(&m_preparer, &Preparer::prepared, this,
        [this](const std::shared_ptr<SceneSimulator>& simulator, quint64 simulation) {
            m_wanted.prepared = simulation == m_wanted.simulation ? simulator : nullptr;
            refresh(usualQuality());
        });
    connect(&m_worker, &PictureWorker::exhausted, this, [this] {
        giveUp();
        emit exhausted();
    });
    connect(&m_worker, &PictureWorker::failed, this, [this](const Error& why) {
        giveUp();
        emit failed(why);
    });
}

void PreviewScheduler::setScene(
    const Scene& scene, std::size_t layer, DirtyStage stale, const std::vector<std::size_t>& solo)
{
    m_wanted.scene = std::make_shared<const Scene>(scene);
    m_wanted.layer = layer;
    m_wanted.solo = solo;
    if (stale >= DirtyStage::Simulate) {
        ++m_wanted.simulation;
        m_wanted.mayBake = true;
        m_wanted.prepared.reset();
        stopPreparing();
    }
    invalidate();
    beginMoving();
    refresh(PreviewQuality::Interactive);
}

void PreviewScheduler::setSolo(const std::vector<std::size_t>& solo)
{
    if (solo != m_wanted.solo) {
        m_wanted.solo = solo;
        invalidate();
        beginMoving();
        refresh(PreviewQuality::Interactive);
    }
}

void PreviewScheduler::setLayer(std::size_t layer)
{
    m_wanted.layer = layer;
    if (m_wanted.trails || m_wanted.air) {
        invalidate();
        refresh(usualQuality());
    }
}

void PreviewScheduler::startAnew()
{
    invalidate();
    m_oldest = m_wanted.revision;
    m_picture.reset();
}

void PreviewScheduler::setFrame(int frame)
{
    if (frame == m_wanted.frame) {
        return;
    }
    m_wanted.frame = frame;
    m_preparer.setFrame(frame);
    if (!m_playing) {
        m_rest.start();
    }
    refresh(m_moving ? PreviewQuality::Interactive : PreviewQuality::Playback);
}

void PreviewScheduler::setPlaying(bool playing)
{
    m_playing = playing;
    if (!playing) {
        stopPreparing(); // the picture that is looked at does it itself
        m_rest.start();
    }
}

void PreviewScheduler::setSeen(bool seen)
{
    m_seen = seen;
    if (seen && !m_picture) {
        // Something to look at first; the whole of it a moment later.
        beginMoving();
    }
    if (!seen) {
        stopPreparing();
    }
    refresh(usualQuality());
}

void PreviewScheduler::setSize(const QSize& pixels)
{
    const int width = std::max(1, pixels.width());
    const int height = std::max(1, pixels.height());
    if (width != m_wanted.width || height != m_wanted.height) {
        m_wanted.width = width;
        m_wanted.height = height;
        invalidate();
        beginMoving();
        refresh(PreviewQuality::Interactive);
    }
}

void PreviewScheduler::setBackdrop(const Backdrop& backdrop)
{
    m_wanted.backdrop = backdrop;
    invalidate();
    refresh(PreviewQuality::Full);
}

void PreviewScheduler::setCacheBytes(qint64 bytes)
{
    m_cache.setRoom(bytes);
    emit cacheChanged();
    emit dropped();
}

void PreviewScheduler::setTrails(bool wanted)
{
    m_wanted.trails = wanted;
    invalidate();
    refresh(PreviewQuality::Full);
}

void PreviewScheduler::setAir(bool wanted)
{
    m_wanted.air = wanted;
    invalidate();
    refresh(PreviewQuality::Full);
}

void PreviewScheduler::setSprites(bool wanted)
{
    m_wanted.sprites = wanted;
    invalidate();
    refresh(PreviewQuality::Full);
}

void PreviewScheduler::setOther(const std::optional<Scene>& other)
{
    m_otherSimulation += other == m_other ? 0 : 1;
    m_other = other;
    if (!other) {
        m_otherWorker.reset();
        m_otherPicture.reset();
        return;
    }
    if (!m_otherWorker) {
        m_otherWorker = std::make_unique<PictureWorker>(m_shelf);
        connect(m_otherWorker.get(), &PictureWorker::pictureReady, this, &PreviewScheduler::receiveOther);
        connect(m_otherWorker.get(), &PictureWorker::exhausted, this, &PreviewScheduler::exhausted);
        connect(m_otherWorker.get(), &PictureWorker::failed, this, &PreviewScheduler::failed);
    }
    requestOther(PreviewQuality::Full);
}

void PreviewScheduler::pick(const glm::vec2& place)
{
    m_wanted.pick = {++m_picks, place}; // until it is answered, with whatever picture comes
    if (m_seen) {
        request(usualQuality());
    }
}

bool PreviewScheduler::isSettled() const
{
    return m_picture && m_picture->complete && isWanted(*m_picture);
}

bool PreviewScheduler::isWanted(const Picture& picture) const
{
    return picture.revision == m_wanted.revision && picture.frame == m_wanted.frame;
}

PreviewQuality PreviewScheduler::usualQuality() const
{
    if (m_moving) {
        return PreviewQuality::Interactive;
    }
    return m_playing ? PreviewQuality::Playback : PreviewQuality::Full;
}

void PreviewScheduler::invalidate()
{
    ++m_wanted.revision;
    m_cache.clear();
    emit cacheChanged();
    emit dropped();
}

void PreviewScheduler::beginMoving()
{
    m_moving = true;
    m_rest.start();
}

void PreviewScheduler::rest()
{
    // What the hand asked for last is still on its way: sharpening it now would only get in its way.
    if (m_asked && m_asked->previewQuality != PreviewQuality::Full) {
        m_rest.start();
        return;
    }
    m_moving = false;
    const PicturePtr known = m_cache.find(m_wanted.frame);
    if (m_seen && known && known->thinned && m_wanted.mayBake && !m_playing) {
        // The whole may take seconds: something in between comes first.
        request(PreviewQuality::Intermediate);
    } else {
        refresh(usualQuality());
    }
}

/// Shows what is known of the present frame, or asks for it.
void PreviewScheduler::refresh(PreviewQuality previewQuality)
{
    if (!m_seen) {
        return;
    }
    requestOther(previewQuality);
    const PicturePtr known = m_cache.find(m_wanted.frame);
    // Of frames that are played, rough ones of the turn before would flash up before those that come now.
    if (known && !(m_playing && previewQuality == PreviewQuality::Playback && known->thinned)) {
        show(known);
    }
    const bool isEnough = known
        && (known->complete || previewQuality == PreviewQuality::Interactive
            || (previewQuality == PreviewQuality::Playback && !known->thinned));
    if (!isEnough) {
        request(previewQuality);
    }
}

void PreviewScheduler::request(PreviewQuality previewQuality)
{
    m_asked = m_wanted;
    m_asked->previewQuality = previewQuality;
    m_wanted.prepared.reset(); // it is handed over once
    emit waitingChanged(true);
    m_worker.request(*m_asked);
}

void PreviewScheduler::requestOther(PreviewQuality previewQuality)
{
    if (!m_other || !m_seen) {
        return;
    }
    Scene scene = *m_other;
    scene.camera = m_wanted.scene->camera;
    scene.output = m_wanted.scene->output;
    RenderRequest other = m_wanted;
    other.scene = std::make_shared<const Scene>(scene);
    other.layer = 0;
    other.solo.clear();
    other.pick = {};
    other.simulation = m_otherSimulation;
    other.previewQuality = previewQuality;
    other.sprites = false;
    other.trails = false;
    other.air = false;
    m_otherWorker->request(other);
}

void PreviewScheduler::receive(const PicturePtr& picture)
{
    if (picture->revision < m_oldest) {
        return;
    }
    const bool settling = m_asked && m_asked->previewQuality == PreviewQuality::Intermediate
        && picture->revision == m_asked->revision && picture->frame == m_asked->frame;
    if (m_asked && picture->frame == m_asked->frame && !settling) {
        m_asked.reset();
        emit waitingChanged(false);
    }
    if (picture->revision == m_wanted.revision) {
        m_cache.keep(picture);
        emit cacheChanged();
    }
    show(picture);
    if (picture->picked.number != 0 && picture->picked.number == m_wanted.pick.number) {
        m_wanted.pick = {};
        emit picked(picture->picked.layer);
    }
    prepareBehind(*picture);
    if (settling) {
        m_asked.reset();
        refresh(usualQuality());
        if (!m_asked) { // that was all there is
            emit waitingChanged(false);
        }
    }
}

void PreviewScheduler::prepareBehind(const Picture& picture)
{
    if (m_playing && !m_moving && m_seen && picture.thinned && m_wanted.mayBake && !m_wanted.prepared
        && isWanted(picture)) {
        m_preparer.prepare(m_wanted.scene, m_wanted.simulation, m_wanted.frame);
    }
}

void PreviewScheduler::stopPreparing()
{
    if (m_preparer.isBusy()) {
        m_preparer.stop();
        emit working(Phase::Idle, 1.0);
    }
}

void PreviewScheduler::stopWork()
{
    m_wanted.mayBake = false;
    stopPreparing();
    if (m_asked) {
        m_worker.stop();
        giveUp();
    }
    emit working(Phase::Idle, 1.0);
    if (!m_picture || !isWanted(*m_picture)) {
        request(PreviewQuality::Interactive); // something of this frame
    }
}

void PreviewScheduler::mayWork()
{
    m_wanted.mayBake = true;
    refresh(usualQuality());
}

void PreviewScheduler::giveUp()
{
    m_asked.reset();
    emit waitingChanged(false);
}

void PreviewScheduler::receiveOther(const PicturePtr& picture)
{
    m_otherPicture = picture;
    emit otherReady(picture);
}

/// What is shown of the wanted frame stays until there is something better of it: pictures that were asked for earlier
/// come later.
void PreviewScheduler::show(const PicturePtr& picture)
{
    const bool isHere = m_picture && isWanted(*m_picture);
    if (picture == m_picture || (isHere && (!isWanted(*picture) || isBetter(*m_picture, *picture)))) {
        return;
    }
    m_picture = picture;
    emit ready(picture);
}

} // namespace fumage::ui
