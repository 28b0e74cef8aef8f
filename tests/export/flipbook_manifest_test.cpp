// The manifest of a flipbook says all that it is made of, so that any machine can make it again.
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/cell_frames.h"
#include "tests/export/small_smoke.h"
#include "tests/helpers.h"

#include "core/export/manifest/verify.h"
#include "core/export/plan.h"

#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A flipbook with everything that changes its files.
ExportPlan fullPlan(const std::filesystem::path& folder)
{
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.output = folder / "smoke 2x2.png";
    plan.frames = {4, 27, 2};
    plan.flipbook.columns = plan.flipbook.rows = 2;
    plan.passes = {Pass::Colour, Pass::SixWayA, Pass::SixWayB, Pass::Motion, Pass::Normal};
    plan.flipbook.engine = Engine::Unity;
    plan.style = styleFor(plan.flipbook.engine, plan.format);
    plan.flipbook.packs = {
        parsePack("masks=shadow,alpha@1/2").value(), parsePack("light=six-way-a.r,0,1,alpha").value()};
    plan.flipbook.retime = parseRetime("[[0, 0], [0.5, 0.8], [1, 1]]").value();
    plan.flipbook.trim = true;
    plan.project = Preset{};
    plan.recording.manifest = manifestBeside(plan.output);
    return plan;
}

std::filesystem::path pathOf(const QTemporaryDir& folder)
{
    return folder.path().toStdString();
}

ManifestSet written(const ExportPlan& plan)
{
    if (const auto done = runExport(smallSmoke(), plan); !done) {
        qFatal("%s", done.error().text().c_str());
    }
    return openManifests(plan.output.parent_path()).value();
}

std::size_t countOf(const std::vector<CheckedFile>& files, FileState state)
{
    return static_cast<std::size_t>(std::ranges::count(files, state, &CheckedFile::state));
}

} // namespace

class FlipbookManifestTest : public QObject {
    Q_OBJECT

private slots:
    void aFlipbookIsMadeAgainFromItsManifest()
    {
        const QTemporaryDir folder;
        const ExportPlan plan = fullPlan(pathOf(folder));
        ManifestSet set = written(plan);
        const Result<std::vector<CheckedFile>> again = renderAgain(set, {0, 99, 1});
        QVERIFY2(again.ok(), again ? "" : again.error().text().c_str());
        QCOMPARE(again.value().size(), filesOf(Scene(), plan).size());
        QVERIFY(again.value().size() >= 7);
        QCOMPARE(countOf(again.value(), FileState::Same), again.value().size());
        set.manifests[0].manifest.files[1].content = set.manifests[0].manifest.files[0].content;
        QCOMPARE(countOf(renderAgain(set, {0, 99, 1}).value(), FileState::Different), std::size_t{1});
    }

    void aPageIsMadeAgainWhateverItsPicturesCarry()
    {
        for (const LayerOutput layers : {LayerOutput::Together, LayerOutput::Alone, LayerOutput::Stacked}) {
            const QTemporaryDir folder;
            ExportPlan plan = fullPlan(pathOf(folder));
            plan.passes = {Pass::Colour};
            plan.flipbook.engine = Engine::Web;
            plan.flipbook.packs.clear();
            plan.layers = layers;
            plan.project->name = "Carried by the pictures, and by them alone";
            const std::vector<CheckedFile> again = renderAgain(written(plan), {0, 99, 1}).value();
            QCOMPARE(again.size(), std::size_t{3});
            QCOMPARE(countOf(again, FileState::Same), again.size());
        }
    }

    void whateverChangesTheFilesIsInTheManifest()
    {
        const QTemporaryDir folder;
        const ManifestSet set = written(fullPlan(pathOf(folder)));
        for (const auto& [key, value] : std::map<std::string, std::string>{{"frames", "4-19:2"},
                 {"packs", "masks=shadow,0@1/2;light=six-way-a.r,0,1,alpha"}, {"retime", ""}, {"vectors", "unreal"},
                 {"normals", "directx"}, {"alpha", "straight"}, {"layout", "embergen"}, {"name", "other.png"},
                 {"columns", "1"}}) {
            ManifestSet other = set;
            std::string& setting = other.manifests[0].manifest.job.settings.at(key);
            setting = key == "alpha" && setting == value ? "premultiplied" : value;
            const Result<std::vector<CheckedFile>> again = renderAgain(other, {0, 99, 1});
            QVERIFY2(again.ok() && countOf(again.value(), FileState::Different) > 0, key.c_str());
        }
    }

    void aFlipbookIsOfTheFramesThatItShows()
    {
        const QTemporaryDir folder;
        ExportPlan plan = fullPlan(pathOf(folder));
        plan.flipbook.trim = false;
        plan.flipbook.retime = {}; // frames 4, 10, 16 and 22
        const ManifestSet set = written(plan);
        QVERIFY(renderAgain(set, {10, 10, 1}).ok());
        QCOMPARE(renderAgain(set, {11, 15, 1}).error().code, ErrorCode::OutOfRange);
    }

    void manifestsThatDoNotSayAllAreRefused()
    {
        const QTemporaryDir folder;
        const ManifestSet set = written(fullPlan(pathOf(folder)));
        for (const auto& [key, value] : std::map<std::string, std::string>{{"frames", ""}, {"columns", "65"},
                 {"rows", "0"}, {"packs", "masks=shadw"}, {"retime", "[[0, 2]]"}, {"for", "quake"},
                 {"untrimmed", "9-2"}, {"name", ""}}) {
            ManifestSet other = set;
            other.manifests[0].manifest.job.settings[key] = value;
            const Result<std::vector<CheckedFile>> again = renderAgain(other, {0, 99, 1});
            QVERIFY2(!again.ok() && again.error().code == ErrorCode::WrongType, key.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(FlipbookManifestTest)
#include "flipbook_manifest_test.moc"
