// SPDX-License-Identifier: GPL-3.0-or-later
// The page "Files" of the handbook is made from the keys that the readers describe. This test fails when a
// page that is kept in resources/handbook differs from them; run with TELETA_WRITE_PAGES=1, it writes the
// pages anew.
#include "app/cli/commands/devices/device_files.h"
#include "app/sources/source_list.h"
#include "backend/core/keys/key_reference.h"
#include "backend/scene/scene.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/session/study_scene.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "devices/bracelet/hid_bracelet_file.h"
#include "devices/modbus/register_map.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "devices/taxels/magnetometers_file.h"
#include "devices/taxels/taxels_file.h"
#include "devices/taxels/xela_file.h"

#include <QFile>
#include <QTest>

#include <array>
#include <functional>

using namespace teleta;

namespace {

enum Section {
    scenes,
    arrayScene,
    armScene,
    cameraScene,
    gelScene,
    servoScene,
    effects,
    taxelEffects,
    jointEffects,
    objectEffects,
    linkEffects,
    contactEffects,
    cameraEffects,
    studyScene,
    protocols,
    devices,
    modbusDevice,
    braceletDevice,
    soundDevice,
    arrayDevice,
    cameraDevice,
    gelDevice,
    taxelsDevice,
    magneticDevice,
    xelaDevice,
    sources,
    sceneSource,
    recordingSource,
    playbackSource,
    arraySource,
    cameraSource,
    armSource,
    taxelsSource,
    gelSource,
    sceneCameraSource,
    sections
};

/// The words of the page in one language; the rows themselves are in English.
struct PageWords {
    const char* language;
    const char* title;
    const char* intro;
    core::ReferenceWords columns;
    std::array<const char*, sections> headings;
};

const std::vector<PageWords>& pages() {
    static const std::vector<PageWords> kPages{
        {"en",
         "Files",
         "Scenes, study protocols, devices and lists of sources are TOML files. This page has every key that "
         "the program "
         "reads from them. A key's name ends in its unit. An unknown key, a missing one and a value out of "
         "range are errors "
         "that name the line.",
         {},
         {"Scenes",
          "A tactile array",
          "An arm among objects",
          "A camera in a soft tube",
          "A flat gel",
          "A servoing arm",
          "Effects",
          "Of any tactile array",
          "Of the joints of an arm",
          "Of the objects that an arm touches",
          "Of the link to the operator",
          "Of the array that a servoing arm carries",
          "Of a camera",
          "A rehearsed study",
          "Study protocols",
          "Devices",
          "Modbus device",
          "Bracelet over USB",
          "Voice coils on a sound card",
          "Weiss array",
          "Camera",
          "Flat gel with markers",
          "Array of any make",
          "Skin of magnetometers",
          "XELA uSkin",
          "Lists of sources",
          "Scene",
          "CSV recording",
          "Recording of this program",
          "Weiss array",
          "Camera",
          "Arm over ROS 2",
          "Array of any make",
          "Flat gel with markers",
          "Camera that only looks"}},
        {"fr",
         "Fichiers",
         "Les scènes, les protocoles d'étude, les appareils et les listes de sources sont des fichiers TOML. "
         "Cette page "
         "donne toutes les clés que le programme y lit. Le nom d'une clé se termine par son unité. Une clé "
         "inconnue, une "
         "clé manquante ou une valeur hors limites est une erreur qui indique la ligne. Les tableaux sont en "
         "anglais.",
         {.key = "Clé",
          .unit = "Unité",
          .accepts = "Valeurs",
          .fallback = "Par défaut",
          .meaning = "Signification",
          .required = "obligatoire",
          .number = "un nombre",
          .whole = "entier",
          .text = "texte",
          .table = "une table",
          .tables = "des tables",
          .list = "liste"},
         {"Scènes",
          "Un réseau tactile",
          "Un bras parmi des objets",
          "Une caméra dans un tube souple",
          "Un gel plat",
          "Un bras asservi",
          "Effets",
          "De tout réseau tactile",
          "Des articulations d'un bras",
          "Des objets que touche un bras",
          "De la liaison avec l'opérateur",
          "Du réseau que porte un bras asservi",
          "D'une caméra",
          "Une étude répétée",
          "Protocoles d'étude",
          "Appareils",
          "Appareil Modbus",
          "Bracelet USB",
          "Bobines sur une carte son",
          "Réseau Weiss",
          "Caméra",
          "Gel plat à marqueurs",
          "Matrice quelconque",
          "Peau à magnétomètres",
          "XELA uSkin",
          "Listes de sources",
          "Scène",
          "Enregistrement CSV",
          "Enregistrement de ce programme",
          "Réseau Weiss",
          "Caméra",
          "Bras sur ROS 2",
          "Matrice quelconque",
          "Gel plat à marqueurs",
          "Caméra qui ne fait que regarder"}},
        {"ja",
         "ファイル",
         "シーン、実験計画、機器、ソースの一覧は TOML "
         "ファイルです。このページには、プログラムが読むすべてのキーがあります。"
         "キーの名前は単位で終わります。未知のキー、足りないキー、範囲外の値は、行番号付きのエラーになります"
         "。表は英語です。",
         {.key = "キー",
          .unit = "単位",
          .accepts = "値",
          .fallback = "省略時",
          .meaning = "意味",
          .required = "必須",
          .number = "数",
          .whole = "整数",
          .text = "文字列",
          .table = "テーブル",
          .tables = "テーブルの配列",
          .list = "リスト"},
         {"シーン",
          "触覚アレイ",
          "物体の中のアーム",
          "柔らかい管の中のカメラ",
          "平らなゲル",
          "サーボするアーム",
          "効果",
          "すべての触覚アレイ",
          "アームの関節",
          "アームが触れる物体",
          "操作者との通信",
          "サーボするアームが持つアレイ",
          "カメラ",
          "実験のリハーサル",
          "実験計画",
          "機器",
          "Modbus 機器",
          "USB ブレスレット",
          "サウンドカード上のボイスコイル",
          "Weiss アレイ",
          "カメラ",
          "マーカー付きの平らなゲル",
          "任意のアレイ",
          "磁気センサーの皮膚",
          "XELA uSkin",
          "ソースの一覧",
          "シーン",
          "CSV の記録",
          "このプログラムの記録",
          "Weiss アレイ",
          "カメラ",
          "ROS 2のアーム",
          "任意のアレイ",
          "マーカー付きの平らなゲル",
          "見るだけのカメラ"}},
        {"zh_CN",
         "文件",
         "场景、实验方案、设备和信号源列表都是 TOML 文件。本页列出程序从中读取的所有键。键名以单位结尾。"
         "未知的键、缺少的键和超出范围的值都会报错，并指出所在行。表格为英文。",
         {.key = "键",
          .unit = "单位",
          .accepts = "取值",
          .fallback = "缺省",
          .meaning = "含义",
          .required = "必填",
          .number = "数",
          .whole = "整数",
          .text = "文本",
          .table = "表",
          .tables = "表数组",
          .list = "列表"},
         {"场景",
          "触觉阵列",
          "物体之间的机械臂",
          "软管中的摄像头",
          "平面凝胶",
          "伺服机械臂",
          "效应",
          "任何触觉阵列",
          "机械臂的关节",
          "机械臂触碰的物体",
          "与操作者的连接",
          "伺服机械臂所持的阵列",
          "摄像头",
          "实验排练",
          "实验方案",
          "设备",
          "Modbus 设备",
          "USB 手环",
          "声卡上的音圈",
          "Weiss 阵列",
          "摄像头",
          "带标记的平面凝胶",
          "任意阵列",
          "磁力计皮肤",
          "XELA uSkin",
          "信号源列表",
          "场景",
          "CSV 记录",
          "本程序的记录",
          "Weiss 阵列",
          "摄像头",
          "通过 ROS 2 的机械臂",
          "任意阵列",
          "带标记的平面凝胶",
          "仅用于观看的摄像头"}},
    };
    return kPages;
}

class FilesPage {
public:
    explicit FilesPage(const PageWords& words)
        : m_words(words)
        , m_text("# " + std::string(words.title) + "\n\n" + words.intro + "\n\n") {}

    void head(int level, Section section) {
        m_text +=
            std::string(static_cast<std::size_t>(level), '#') + ' ' + m_words.headings[section] + "\n\n";
    }
    void part(int level, Section section, const std::function<void(core::Keys&)>& describe) {
        head(level, section);
        core::KeyReference reference(m_words.columns);
        describe(reference);
        m_text += reference.markdown(level + 1);
    }
    [[nodiscard]] QByteArray text() const { return QByteArray::fromStdString(m_text).trimmed() + '\n'; }

private:
    const PageWords& m_words;
    std::string m_text;
};

std::function<void(core::Keys&)> effectsOn(scene::ActsOn what) {
    return [what](core::Keys& keys) {
        std::vector<scene::Effect> effects;
        keys.tables("effects", effects, 0, {},
                    [what](core::Keys& table, std::vector<scene::Effect>& all, std::size_t i) {
                        scene::describeEffect(table, all[i], {what}, {}, {});
                    });
    };
}

std::function<void(core::Keys&)> sourceOf(app::SourceKind kind) {
    return [kind](core::Keys& keys) {
        std::vector<int> tables;
        keys.tables("source", tables, 1, {}, [kind](core::Keys& table, std::vector<int>&, std::size_t) {
            std::vector<app::SourceRequest> requests;
            app::describeSource(table, kind, {}, requests);
        });
    };
}

template <typename File>
void describeFile(core::Keys& keys) {
    File file;
    file.describeKeys(keys);
}

QByteArray pageOf(const PageWords& words) {
    FilesPage page(words);
    page.part(2, scenes, [](core::Keys& keys) { scene::Scene().describeHead(keys); });
    page.part(3, arrayScene, describeFile<scene::ArrayWorld>);
    page.part(3, armScene, describeFile<scene::ArmWorld>);
    page.part(3, cameraScene, describeFile<scene::CameraWorld>);
    page.part(3, gelScene, describeFile<scene::GelWorld>);
    page.part(3, servoScene, describeFile<scene::ServoWorld>);
    page.part(3, studyScene, describeFile<study::StudyScene>);
    page.head(2, effects);
    page.part(3, taxelEffects, effectsOn(scene::ActsOn::taxels));
    page.part(3, jointEffects, effectsOn(scene::ActsOn::joints));
    page.part(3, objectEffects, effectsOn(scene::ActsOn::armObjects));
    page.part(3, linkEffects, effectsOn(scene::ActsOn::link));
    page.part(3, contactEffects, effectsOn(scene::ActsOn::carriedArray));
    page.part(3, cameraEffects, effectsOn(scene::ActsOn::camera));
    page.part(2, protocols, describeFile<study::Protocol>);
    page.head(2, devices);
    page.part(3, modbusDevice, describeFile<modbus::RegisterMap>);
    page.part(3, braceletDevice, describeFile<bracelet::HidBraceletFile>);
    page.part(3, soundDevice, describeFile<sound::SoundBraceletFile>);
    page.part(3, arrayDevice, describeFile<cli::ArrayFile>);
    page.part(3, cameraDevice, describeFile<cli::CameraFile>);
    page.part(3, gelDevice, describeFile<vision::MarkerGelFile>);
    page.part(3, taxelsDevice, describeFile<taxels::TaxelsFile>);
    page.part(3, magneticDevice, describeFile<taxels::MagnetometersFile>);
    page.part(3, xelaDevice, describeFile<taxels::XelaFile>);
    page.head(2, sources);
    page.part(3, sceneSource, sourceOf(app::SourceKind::scene));
    page.part(3, recordingSource, sourceOf(app::SourceKind::recording));
    page.part(3, playbackSource, sourceOf(app::SourceKind::playback));
    page.part(3, arraySource, sourceOf(app::SourceKind::wts));
    page.part(3, cameraSource, sourceOf(app::SourceKind::camera));
    page.part(3, armSource, sourceOf(app::SourceKind::arm));
    page.part(3, taxelsSource, sourceOf(app::SourceKind::taxels));
    page.part(3, gelSource, sourceOf(app::SourceKind::gel));
    page.part(3, sceneCameraSource, sourceOf(app::SourceKind::sceneCamera));
    return page.text();
}

} // namespace

class FilesPageTest : public QObject {
    Q_OBJECT

private slots:
    void isWhatTheReadersDescribe() {
        for (const PageWords& words : pages()) {
            QFile file(QStringLiteral(TELETA_SOURCE_DIR "/resources/handbook/%1/files.md")
                           .arg(QLatin1String(words.language)));
            if (qEnvironmentVariableIsSet("TELETA_WRITE_PAGES")) {
                QVERIFY(file.open(QIODevice::WriteOnly));
                file.write(pageOf(words));
                continue;
            }
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            QVERIFY2(
                file.readAll() == pageOf(words),
                qPrintable(file.fileName() +
                           " is not what the readers describe: run this test with TELETA_WRITE_PAGES=1"));
        }
    }

    void everyKeyHasItsMeaning() {
        const QByteArray page = pageOf(pages().front());
        for (const QByteArray& line : page.split('\n'))
            QVERIFY2(!line.startsWith("| `") || !line.endsWith("|  |"), line.constData());
    }
};

QTEST_GUILESS_MAIN(FilesPageTest)
#include "files_page_test.moc"
