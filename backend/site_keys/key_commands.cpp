// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/site_keys/site_keys.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QRegularExpression>

#include <set>

namespace teleta::site_keys {

namespace {

struct MakingText {
    Q_DECLARE_TR_FUNCTIONS(SiteKeys)
};

constexpr int kDays = 90;

constexpr const char* kAuthorities = R"(
# The permissions authority signs governance and permissions, never a certificate.
for ca in identity_ca permissions_ca; do
    [ ! -e $ca.pem ] || continue
    openssl ecparam -name prime256v1 -genkey -noout -out ${ca}_key.pem; chmod 600 ${ca}_key.pem
    openssl req -x509 -new -sha256 -key ${ca}_key.pem -days 3650 -subj "/O=TeleTA site/CN=$ca" \
        -addext "basicConstraints=critical,CA:TRUE" \
        -addext "keyUsage=critical,digitalSignature,keyCertSign,cRLSign" -out $ca.pem
done

cat > governance.xml <<'END'
<?xml version="1.0" encoding="utf-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:noNamespaceSchemaLocation="https://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_governance.xsd">
  <domain_access_rules>
    <domain_rule>
      <domains><id_range><min>0</min><max>230</max></id_range></domains>
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>SIGN</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>NONE</metadata_protection_kind>
          <data_protection_kind>ENCRYPT</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
END
openssl smime -sign -text -in governance.xml -out governance.p7s -signer permissions_ca.pem \
    -inkey permissions_ca_key.pem
)";

constexpr const char* kPermissions = R"(
cat > permissions_%1.xml <<'END'
<?xml version="1.0" encoding="utf-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:noNamespaceSchemaLocation="https://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd">
  <permissions>
    <grant name="%1">
      <subject_name>CN=%1,O=TeleTA site</subject_name>
      <validity><not_before>%2</not_before><not_after>%3</not_after></validity>
      <allow_rule>
        <domains><id_range><min>0</min><max>230</max></id_range></domains>
        <publish><topics>%4</topics></publish>
        <subscribe><topics>%5</topics></subscribe>
      </allow_rule>
      <default>DENY</default>
    </grant>
  </permissions>
</dds>
END
)";

constexpr const char* kMembers = R"(
for n in %1; do
    mkdir -p $n
    [ -e $n/key.pem ] || openssl ecparam -name prime256v1 -genkey -noout -out $n/key.pem; chmod 600 $n/key.pem
    openssl req -new -sha256 -key $n/key.pem -subj "/O=TeleTA site/CN=$n" -out $n/req.pem
    openssl x509 -req -sha256 -in $n/req.pem -CA identity_ca.pem -CAkey identity_ca_key.pem -CAcreateserial \
        -days %2 -out $n/cert.pem
    openssl smime -sign -text -in permissions_$n.xml -out $n/permissions.p7s -signer permissions_ca.pem \
        -inkey permissions_ca_key.pem
done
)";

QString elements(const std::vector<std::string>& topics) {
    QString text;
    for (const std::string& topic : topics)
        text += QStringLiteral("<topic>%1</topic>").arg(QString::fromStdString(topic));
    return text;
}

/// The start of the day, so that a clock that is a little slow does not matter.
QString dayAt(std::int64_t unixS) {
    return QDateTime::fromSecsSinceEpoch(unixS, Qt::UTC).date().toString(Qt::ISODate) +
           QStringLiteral("T00:00:00");
}

QString quotedForShell(const std::string& path) {
    QString text = QString::fromStdString(path);
    return QLatin1Char('\'') + text.replace(QLatin1Char('\''), QStringLiteral("'\\''")) + QLatin1Char('\'');
}

core::Expected<void> checkNames(const KeyPlan& plan) {
    static const QRegularExpression form(QStringLiteral("\\A[a-z][a-z0-9_]{0,30}\\z"));
    const auto check = [](const std::string& name) -> core::Expected<void> {
        if (form.match(QString::fromStdString(name)).hasMatch())
            return {};
        return core::failed(core::ErrorKind::badInput,
                            MakingText::tr("'%1' is not a valid name for a site or a console")
                                .arg(QString::fromStdString(name)),
                            MakingText::tr("a lowercase letter, then at most 30 of a-z, 0-9 and _"));
    };
    TELETA_CHECK(check(plan.site));
    std::set<std::string> taken{kSiteMember};
    for (const std::vector<std::string>* names : {&plan.consoles, &plan.viewers})
        for (const std::string& name : *names) {
            TELETA_CHECK(check(name));
            if (!taken.insert(name).second)
                return core::failed(
                    core::ErrorKind::badInput,
                    MakingText::tr("'%1' is already taken").arg(QString::fromStdString(name)));
        }
    return {};
}

} // namespace

core::Expected<std::string> commandsFor(const KeyPlan& plan, std::int64_t now_unixS) {
    TELETA_CHECK(checkNames(plan));
    QString text =
        QStringLiteral("set -e\numask 077\nmkdir -p -- %1\ncd -- %1\n").arg(quotedForShell(plan.folder));
    text += QLatin1String(kAuthorities);
    QStringList names;
    const auto add = [&](const std::string& name, MemberRole role) {
        names << QString::fromStdString(name);
        const MemberTopics topics = topicsOf(role, plan.site, name);
        text +=
            QString::fromLatin1(kPermissions)
                .arg(names.back(), dayAt(now_unixS), dayAt(now_unixS + (kDays + 1) * std::int64_t{86'400}),
                     elements(topics.publish), elements(topics.subscribe));
    };
    add(kSiteMember, MemberRole::site);
    for (const std::string& name : plan.consoles)
        add(name, MemberRole::console);
    for (const std::string& name : plan.viewers)
        add(name, MemberRole::viewer);
    text += QString::fromLatin1(kMembers).arg(names.join(QLatin1Char(' '))).arg(kDays);
    return text.toStdString();
}

} // namespace teleta::site_keys
