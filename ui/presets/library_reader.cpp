#include "ui/presets/library_reader.h"

#include "ui/document/text.h"

#include <QElapsedTimer>

#include <utility>

namespace fumage::ui {

namespace {

/// Often enough that a list is seen to grow, seldom enough that it is not laid out for every item.
constexpr qint64 kSendMs = 50;

LibraryPreset readEntry(const LibraryEntry& entry)
{
    LibraryPreset read{entry, {}, {}};
    const auto fail = [&](const Error& why) { read.trouble = translated(why); };
    // One that cannot be read costs no other.
    runGuarded(
        [&] {
            Result<PresetReading> reading = loadPreset(entry);
            reading ? static_cast<void>(read.preset = std::move(reading).value().preset) : fail(reading.error());
        },
        fail);
    return read;
}

} // namespace

LibraryReader::LibraryReader(QObject* parent)
    : QObject(parent)
    , m_job([this](quint64 number, const std::stop_token& stop) { work(number, stop); },
          [this](quint64 number, const Error& why) {
              send(number, {{{}, {}, translated(why)}}, true);
          })
{
}

void LibraryReader::read()
{
    m_job.post(++m_newest);
}

void LibraryReader::work(quint64 number, const std::stop_token& stop)
{
    std::vector<LibraryEntry> entries = presetsIn(userPresetFolder());
    const std::vector<LibraryEntry> builtin = builtinPresets();
    entries.insert(entries.end(), builtin.begin(), builtin.end());
    std::vector<LibraryPreset> some;
    bool first = true;
    QElapsedTimer sinceSent;
    sinceSent.start();
    for (const LibraryEntry& entry : entries) {
        if (stop.stop_requested()) {
            return;
        }
        some.push_back(readEntry(entry));
        if (sinceSent.elapsed() > kSendMs) {
            send(number, std::exchange(some, {}), std::exchange(first, false));
            sinceSent.start();
        }
    }
    send(number, std::move(some), first);
}

void LibraryReader::send(quint64 number, std::vector<LibraryPreset> presets, bool first)
{
    QMetaObject::invokeMethod(
        this,
        [this, number, presets = std::move(presets), first] {
            if (number == m_newest) {
                emit found(presets, first);
            }
        },
        Qt::QueuedConnection);
}

} // namespace fumage::ui
