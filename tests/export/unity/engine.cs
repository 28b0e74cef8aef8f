// As much of Unity as the scripts of sheets use: compiled with them, it makes what they make, and prints it. Signatures are those of Unity's
// documentation; what is not asked for does nothing.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text;

namespace UnityEngine
{
    public struct Color
    {
        public Color(float r, float g, float b) { }
    }

    public class Object
    {
        public string name { get; set; }
        public static void DestroyImmediate(Object thing) { }
    }

    public class Component : Object
    {
        public Transform transform { get; } = new Transform();
    }

    public class Transform : Object // in Unity a component, too
    {
        public void SetParent(Transform parent, bool worldPositionStays) { }
    }

    public class GameObject : Object
    {
        private readonly List<object> m_parts = new List<object>();
        public Transform transform { get; } = new Transform();
        public GameObject(string name) { this.name = name; Seen.Line("object", name); }
        public T AddComponent<T>() where T : Component, new()
        {
            var part = new T();
            m_parts.Add(part);
            if (part is ParticleSystem)
            {
                m_parts.Add(new ParticleSystemRenderer());
            }
            return part;
        }
        public T GetComponent<T>() => m_parts.OfType<T>().First();
    }

    public class Texture : Object { }
    public class Texture2D : Texture { }

    public class Shader : Object
    {
        public static Shader Find(string name) => new Shader();
    }

    public class Material : Object
    {
        public Material(Shader shader) { }
        public Texture mainTexture { get; set; }
        public int renderQueue { get; set; }
        public bool HasProperty(string name) => true;
        public void SetTexture(string name, Texture value) { }
        public void SetFloat(string name, float value) { }
        public void EnableKeyword(string keyword) { }
        public void SetOverrideTag(string tag, string value) { }
    }

    public static class Debug
    {
        public static void Log(object message) { }
        public static void LogWarning(object message) { }
        public static void LogError(object message) { Seen.Line("error", message.ToString()); }
    }

    public static class Mathf
    {
        public static int Clamp(int value, int min, int max) => Math.Max(min, Math.Min(max, value));
        public static int NextPowerOfTwo(int value) => value;
    }

    public struct GradientColorKey
    {
        public GradientColorKey(Color col, float time) { color = col; this.time = time; }
        public Color color;
        public float time;
    }

    public struct GradientAlphaKey
    {
        public GradientAlphaKey(float alpha, float time) { }
    }

    public class Gradient
    {
        public GradientColorKey[] colorKeys { get; private set; } = new GradientColorKey[0];
        public void SetKeys(GradientColorKey[] colorKeys, GradientAlphaKey[] alphaKeys) { this.colorKeys = colorKeys; }
    }

    public struct Keyframe
    {
        public Keyframe(float time, float value) { }
    }

    public class AnimationCurve
    {
        public AnimationCurve(params Keyframe[] keys) { }
        public static AnimationCurve Constant(float timeStart, float timeEnd, float value) => new AnimationCurve();
        public static AnimationCurve Linear(float timeStart, float valueStart, float timeEnd, float valueEnd) => new AnimationCurve();
    }

    public enum WrapMode { Default, Once, Loop, PingPong, ClampForever }
    public enum SendMessageOptions { RequireReceiver, DontRequireReceiver }

    public class AnimationEvent
    {
        public float time { get; set; }
        public string functionName { get; set; }
        public string stringParameter { get; set; }
        public int intParameter { get; set; }
        public SendMessageOptions messageOptions { get; set; }
    }

    public class AnimationClip : Object
    {
        public bool legacy { get; set; }
        public WrapMode wrapMode { get; set; }
        public void SetCurve(string relativePath, Type type, string propertyName, AnimationCurve curve) { }
    }

    public class Animation : Component
    {
        public AnimationClip clip { get; set; }
        public bool playAutomatically { get; set; }
        public void AddClip(AnimationClip clip, string newName) { }
    }

    public enum TextureWrapMode { Repeat, Clamp }
    public enum ParticleSystemAnimationMode { Grid, Sprites }
    public enum ParticleSystemAnimationType { WholeSheet, SingleRow }
    public enum ParticleSystemVertexStream { Position, Normal, Tangent, Color, UV, UV2, UV3, UV4, AnimBlend }

    public class ParticleSystem : Component
    {
        public MainModule main => new MainModule();
        public EmissionModule emission => new EmissionModule();
        public ShapeModule shape => new ShapeModule();
        public TextureSheetAnimationModule textureSheetAnimation => new TextureSheetAnimationModule();

        public struct MinMaxCurve
        {
            public MinMaxCurve(float constant) { }
            public MinMaxCurve(float multiplier, AnimationCurve curve) { }
            public static implicit operator MinMaxCurve(float constant) => new MinMaxCurve(constant);
        }

        public struct Burst
        {
            public Burst(float time, short count) { }
        }

        public struct MainModule
        {
            public float duration { set { } }
            public bool loop { set { } }
            public MinMaxCurve startLifetime { set { } }
            public MinMaxCurve startSpeed { set { } }
            public bool startSize3D { set { } }
            public MinMaxCurve startSizeX { set { } }
            public MinMaxCurve startSizeY { set { } }
            public MinMaxCurve startSizeZ { set { } }
            public int maxParticles { set { } }
        }

        public struct EmissionModule
        {
            public MinMaxCurve rateOverTime { set { } }
            public void SetBursts(Burst[] bursts) { }
        }

        public struct ShapeModule
        {
            public bool enabled { set { } }
        }

        public struct TextureSheetAnimationModule
        {
            public bool enabled { set { } }
            public ParticleSystemAnimationMode mode { set { } }
            public int numTilesX { set { } }
            public int numTilesY { set { } }
            public ParticleSystemAnimationType animation { set { } }
            public MinMaxCurve frameOverTime { set { } }
            public int cycleCount { set { } }
        }
    }

    public class Renderer : Component
    {
        public Material sharedMaterial { get; set; }
        public int sortingOrder { get; set; }
    }

    public class ParticleSystemRenderer : Renderer
    {
        public void SetActiveVertexStreams(List<ParticleSystemVertexStream> streams) { }
    }
}

namespace UnityEngine.Rendering
{
    public enum BlendMode { Zero, One, DstColor, SrcColor, OneMinusDstColor, SrcAlpha, OneMinusSrcColor, DstAlpha, OneMinusDstAlpha, SrcAlphaSaturate, OneMinusSrcAlpha }
    public enum RenderQueue { Background = 1000, Geometry = 2000, Transparent = 3000 }
}

namespace UnityEditor
{
    using UnityEngine;

    public class AssetImporter : UnityEngine.Object { }
    public enum TextureImporterType { Default }
    public enum TextureImporterCompression { Uncompressed, Compressed, CompressedHQ, CompressedLQ }

    public class TextureImporter : AssetImporter
    {
        public TextureImporterType textureType { get; set; }
        public bool sRGBTexture { get; set; }
        public bool alphaIsTransparency { get; set; }
        public bool mipmapEnabled { get; set; }
        public TextureWrapMode wrapMode { get; set; }
        public int maxTextureSize { get; set; }
        public TextureImporterCompression textureCompression { get; set; }
    }

    public class AssetPostprocessor
    {
        public string assetPath { get; set; }
        public AssetImporter assetImporter { get; set; }
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MenuItem : Attribute
    {
        public MenuItem(string itemName) { }
    }

    public enum InteractionMode { AutomatedAction, UserAction }

    public static class PrefabUtility
    {
        public static GameObject SaveAsPrefabAssetAndConnect(GameObject thing, string assetPath, InteractionMode action) => thing;
    }

    public static class Selection
    {
        public static GameObject activeGameObject { get; set; }
    }

    /// A project that has every picture that is looked for.
    public static class AssetDatabase
    {
        private static readonly List<string> s_files = new List<string>();
        internal static void Add(string file) { s_files.Add(file); }
        public static string[] FindAssets(string filter) => s_files.Select((file, i) => i.ToString()).ToArray();
        public static string GUIDToAssetPath(string guid) => "Assets/" + s_files[int.Parse(guid)];
        public static T LoadAssetAtPath<T>(string assetPath) where T : UnityEngine.Object, new() => new T();
        public static void CreateAsset(UnityEngine.Object asset, string path) { }
        public static string GenerateUniqueAssetPath(string path) => path;
    }

    public static class AnimationUtility
    {
        public static void SetAnimationEvents(AnimationClip clip, AnimationEvent[] events)
        {
            foreach (AnimationEvent each in events)
            {
                Seen.Line("event " + each.functionName + " " + each.time.ToString("R", System.Globalization.CultureInfo.InvariantCulture) + " " + each.intParameter, each.stringParameter);
            }
        }
    }
}

/// What scripts have made, a line each: words, and a name as the hexadecimal bytes of its UTF-8.
internal static class Seen
{
    internal static void Line(string words, string name)
    {
        Console.WriteLine(words + " " + BitConverter.ToString(Encoding.UTF8.GetBytes(name)).Replace("-", "").ToLowerInvariant());
    }
}

internal static class Program
{
    /// The menu item of every script, in a project with the pictures that are named.
    private static void Main(string[] pictures)
    {
        foreach (string picture in pictures)
        {
            UnityEditor.AssetDatabase.Add(picture);
        }
        foreach (Type type in Assembly.GetExecutingAssembly().GetTypes().Where(each => each.Name == "Maker"))
        {
            Console.WriteLine("script " + type.Namespace);
            type.GetMethod("Make", BindingFlags.NonPublic | BindingFlags.Static).Invoke(null, null);
        }
    }
}
