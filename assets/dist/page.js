/*! This page holds the following libraries.

three 0.187.0 (MIT)

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32 (MIT)

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
function B(n,e={},...t){let i=document.createElement(n);return ex(i,e),i.append(...t.flat(1/0).filter(s=>s!=null&&s!==!1)),i}var Q0="http://www.w3.org/2000/svg";function tl(n,e={},...t){let i=document.createElementNS(Q0,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t.flat(1/0)),i}function ex(n,e){for(let[t,i]of Object.entries(e))i==null||i===!1||(t.startsWith("on")?n.addEventListener(t.slice(2),i):t==="text"?n.textContent=i:t==="class"?n.className=i:t in n&&!t.startsWith("aria")&&t!=="list"?n[t]=i:n.setAttribute(t,i===!0?"":i))}var tx=0,hr=n=>`${n}-${tx+=1}`,Ot="\u2013",de=(n,e=4)=>Number.isFinite(n)?n.toFixed(e):Ot,nl=(n,e=3)=>Number.isFinite(n)?n.toFixed(e):Ot,Ie=n=>n.toLocaleString("en-US"),qe=(n,e)=>`${Ie(n)} ${e}${n===1?"":"s"}`;function rt(n){if(n==null||!Number.isFinite(n))return Ot;let e=Math.abs(n);return n!==0&&(e<.001||e>=1e6)?n.toExponential(2):String(Number(n.toPrecision(5)))}function Bd(n,e){if(!Number.isFinite(e)||e<=0||!Number.isFinite(n))return`${rt(n)} \xB1 ${rt(e)}`;let t=a=>Math.floor(Math.log10(Math.abs(a))),i=Math.abs(n),s=n!==0&&(i<.001||i>=1e6)?t(n):0,r=Math.min(Math.max(s-t(e)+1,0),9),o=a=>`${(a/10**s).toFixed(r)}${s===0?"":`e${s}`}`;return`${o(n)} \xB1 ${o(e)}`}function Yo(n){let e=!1;return()=>{e||(e=!0,requestAnimationFrame(()=>{e=!1,n()}))}}var Od=globalThis.requestIdleCallback??(n=>setTimeout(()=>n({timeRemaining:()=>5}),100));function il(n,e){let t=0,i=s=>{for(;t<n&&s.timeRemaining()>2;t+=1)e(t);t<n&&Od(i)};Od(i)}function Wr(n){let e=[];return{...n,set(t){let i=Object.keys(t).filter(s=>this[s]!==t[s]);if(i.length!==0){Object.assign(this,t);for(let[s,r]of e)s.some(o=>i.includes(o))&&r(this)}},on(t,i){e.push([t.split(" "),i])}}}var nx=[0,0,0],sl=class{constructor(e){let{course:t,points:i}=e;this.t=t.t,this.shares=t.shares,this.offsets=t.offsets,this.hasModel=t.has_model,this.model=e.model??null,this.from=t.from_c??0,this.byTemperature=t.from_c!==null&&t.from_c!==void 0,this.unit=this.byTemperature?"\xB0C":"min",this.end=this.t[this.t.length-1],this.points=i,this.count=i.motion.length,this.nodes=this.shares.length}at(e){let t=this.t.length-1,i=Math.min(Math.max(e/this.end*t,0),t),s=Math.min(Math.floor(i),t-1),r=i-s;return this.shares.map(o=>o[s]+(o[s+1]-o[s])*r)}get isByTarget(){return this.model!==null&&this.model.still.columns.length+this.model.moving.columns.length>0}deviation(e,t){let i=this.at(t);if(!this.model)return{turns:null,offsets:this.offsets[0].map((u,f)=>u.map((h,d)=>i.reduce((p,y,g)=>p+y*this.offsets[g][f][d],0)))};let{common:s,still:r,moving:o}=this.model,a=s[0].map((u,f)=>i.reduce((h,d,p)=>h+d*s[p][f],0)),{length:l}=r.columns;r.columns.forEach((u,f)=>{a[u]=r.values[e*l+f]});let{length:c}=o.columns;return o.columns.forEach((u,f)=>{a[u]=i.reduce((h,d,p)=>h+d*o.values[(e*this.nodes+p)*c+f],0)}),{turns:a.slice(0,6),offsets:Array.from({length:7},(u,f)=>a.slice(6+6*f,12+6*f))}}error(e,t,i=[0,0,0],s=0){let{e_mm:r}=this.points;for(let o=0;o<3;o+=1){let a=0;for(let l=0;l<this.nodes;l+=1)a+=t[l]*r[(e*this.nodes+l)*3+o];i[s+o]=a}return i}position(e){return this.points.p_mm.slice(3*e,3*e+3)}joints(e){return this.points.q_deg.slice(6*e,6*e+6)}tool(e){return this.points.tools[this.points.tool[e]]??nx}},rl=class{constructor(e,t){this.course=e,this.buckets=t.buckets.map(i=>({...i,shares:e.at(i.at_min)})),this.left=t.worst_after_mm}get inBuckets(){return this.buckets.length>0}bucketAt(e){return this.buckets.find(t=>t.to_min===null||e<t.to_min)??null}leftShares(e){let t=this.course.at(e),i=this.bucketAt(e);return i?t.map((s,r)=>s-i.shares[r]):t.map(()=>0)}correctedShares(e){return this.bucketAt(e)?.shares??this.course.at(e)}},yi=([n,e,t])=>Math.hypot(n,e,t);function kd(n,e,t){let i=ix(n),s=r=>{if(n.nodes===1)return Math.abs(r[0])*i[0];let o=0,a=[0,0,0];for(let l=0;l<n.count;l+=1)n.error(l,r,a),o=Math.max(o,a[0]*a[0]+a[1]*a[1]+a[2]*a[2]);return Math.sqrt(o)};return{before:t.map(r=>s(n.at(r))),after:e.inBuckets?t.map(r=>s(e.leftShares(r))):null}}function ix(n){let e=new Array(n.nodes).fill(0);for(let t=0;t<n.count;t+=1)for(let i=0;i<n.nodes;i+=1){let s=(t*n.nodes+i)*3;e[i]=Math.max(e[i],yi(n.points.e_mm.slice(s,s+3)))}return e}var ur=Math.PI/180,Xh=()=>[1,0,0,0,0,1,0,0,0,0,1,0];function gs(n,e){let t=new Array(12);for(let i=0;i<12;i+=4)for(let s=0;s<4;s+=1)t[i+s]=n[i]*e[s]+n[i+1]*e[4+s]+n[i+2]*e[8+s]+(s===3?n[i+3]:0);return t}var qh=(n,[e,t,i])=>[n[0]*e+n[1]*t+n[2]*i+n[3],n[4]*e+n[5]*t+n[6]*i+n[7],n[8]*e+n[9]*t+n[10]*i+n[11]],$h=([n,e,t])=>[1,0,0,n,0,1,0,e,0,0,1,t];function fr([n,e,t],i){let s=Math.cos(i),r=Math.sin(i),o=1-s;return[s+n*n*o,n*e*o-t*r,n*t*o+e*r,0,e*n*o+t*r,s+e*e*o,e*t*o-n*r,0,t*n*o-e*r,t*e*o+n*r,s+t*t*o,0]}var zd=[1,0,0],Vd=[0,1,0],Gd=[0,0,1],sx=([n,e,t])=>gs(fr(Gd,t*ur),gs(fr(Vd,e*ur),fr(zd,n*ur))),rx=([n,e,t])=>gs(fr(zd,n*ur),gs(fr(Vd,e*ur),fr(Gd,t*ur)));function ol(n){let e=({origin_mm:i,rpy_deg:s})=>({place:$h(i),turned:sx(s)});return{joints:n.joint.map(i=>({frame:e(i),axis:i.axis,slides:i.type==="prismatic",range:i.range_deg??i.range_mm})),flange:e(n.flange)}}function Hd(n,e,{offsets:t=null,turns:i=null}={},s=1){let r=[],o=Xh(),a=({place:l,turned:c},u)=>{if(o=gs(o,l),u){let f=u.map(h=>h*s);o=gs(o,gs($h(f.slice(0,3)),rx(f.slice(3))))}o=gs(o,c)};return n.joints.forEach((l,c)=>{a(l.frame,t?.[c]);let u=e[c]+(i?.[c]??0)*s;o=gs(o,l.slides?$h(l.axis.map(f=>f*u)):fr(l.axis,u*ur)),r.push(o)}),a(n.flange,t?.[n.joints.length]),r.push(o),r}var Qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},er={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},bp=0,wu=1,Mp=2;var Ea=1,wp=2,yo=3,tr=0,Qn=1,ns=2,xr=0,vo=1,Tu=2,Eu=3,Au=4,Tp=5;var yr=100,Ep=101,Ap=102,Cp=103,Rp=104,Pp=200,Ip=201,Lp=202,Dp=203,Cu=204,Ru=205,Np=206,Up=207,Fp=208,Op=209,Bp=210,kp=211,zp=212,Vp=213,Gp=214,Dl=0,Nl=1,Ul=2,ro=3,Fl=4,Ol=5,Bl=6,kl=7,dc=0,Hp=1,Wp=2,is=0,Pu=1,Iu=2,Lu=3,Du=4,Nu=5,Uu=6,Fu=7;var Ou=300,vr=301,So=302,pc=303,mc=304,zl=1e3,Ji=1001,Vl=1002,Ln=1003,$p=1004;var Aa=1005;var Jn=1006,gc=1007;var As=1008;var ni=1009,Bu=1010,ku=1011,bo=1012,_c=1013,Ui=1014,Fi=1015,Oi=1016,xc=1017,yc=1018,Sr=1020,zu=35902,Vu=35899,Gu=1021,Hu=1022,Bi=1023,Ms=1026,Cs=1027,Wu=1028,vc=1029,nr=1030,Sc=1031;var bc=1033,Ca=33776,Ra=33777,Pa=33778,Ia=33779,Mc=35840,wc=35841,Tc=35842,Ec=35843,Ac=36196,Cc=37492,Rc=37496,Pc=37488,Ic=37489,La=37490,Lc=37491,Dc=37808,Nc=37809,Uc=37810,Fc=37811,Oc=37812,Bc=37813,kc=37814,zc=37815,Vc=37816,Gc=37817,Hc=37818,Wc=37819,$c=37820,Xc=37821,qc=36492,Yc=36494,Zc=36495,jc=36283,Jc=36284,Da=36285,Kc=36286;var ia=2300,Gl=2301,Il=2302,mu=2303,gu=2400,_u=2401,xu=2402;var Xp=3200;var Qc=0,qp=1,Rs="",hi="srgb",sa="srgb-linear",ra="linear",Pt="srgb";var Ll=7680;var Yp=519,Zp=512,jp=513,Jp=514,$u=515,Kp=516,Qp=517,Xu=518,qu=519,em=35044;var Yu="300 es",Si=2e3,oo=2001;function ox(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function ax(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function oa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function tm(){let n=oa("canvas");return n.style.display="block",n}var Wd={},ao=null;function Zu(...n){let e="THREE."+n.shift();ao?ao("log",e,...n):console.log(e,...n)}function nm(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function je(...n){n=nm(n);let e="THREE."+n.shift();if(ao)ao("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=nm(n);let e="THREE."+n.shift();if(ao)ao("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ea(...n){let e=n.join(" ");e in Wd||(Wd[e]=!0,je(...n))}function im(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var sm={[Dl]:Dl,[Ul]:Bl,[Fl]:Fl,[ro]:Ol,[Nl]:Nl,[Bl]:Ul,[kl]:kl,[Ol]:ro},Ni=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],$d=1234567,ta=Math.PI/180,lo=180/Math.PI;function Mo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(kn[n&255]+kn[n>>8&255]+kn[n>>16&255]+kn[n>>24&255]+"-"+kn[e&255]+kn[e>>8&255]+"-"+kn[e>>16&15|64]+kn[e>>24&255]+"-"+kn[t&63|128]+kn[t>>8&255]+"-"+kn[t>>16&255]+kn[t>>24&255]+kn[i&255]+kn[i>>8&255]+kn[i>>16&255]+kn[i>>24&255]).toLowerCase()}function yt(n,e,t){return Math.max(e,Math.min(t,n))}function ju(n,e){return(n%e+e)%e}function lx(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function cx(n,e,t){return n!==e?(t-n)/(e-n):0}function na(n,e,t){return(1-t)*n+t*e}function hx(n,e,t,i){return na(n,e,1-Math.exp(-t*i))}function ux(n,e=1){return e-Math.abs(ju(n,e*2)-e)}function fx(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function dx(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function px(n,e){return n+Math.floor(Math.random()*(e-n+1))}function mx(n,e){return n+Math.random()*(e-n)}function gx(n){return n*(.5-Math.random())}function _x(n){n!==void 0&&($d=n);let e=$d+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function xx(n){return n*ta}function yx(n){return n*lo}function vx(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Sx(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Ju(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function bx(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ku(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function rm(n,e){if(e.constructor===Float32Array)return n;let t=Ku(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function om(n,e){if(e.constructor===Float32Array)return n;let t=Ku(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Qu={DEG2RAD:ta,RAD2DEG:lo,generateUUID:Mo,clamp:yt,euclideanModulo:ju,mapLinear:lx,inverseLerp:cx,lerp:na,damp:hx,pingpong:ux,smoothstep:fx,smootherstep:dx,randInt:px,randFloat:mx,randFloatSpread:gx,seededRandom:_x,degToRad:xx,radToDeg:yx,isPowerOfTwo:vx,ceilPowerOfTwo:Sx,floorPowerOfTwo:Ju,setQuaternionFromProperEuler:bx,normalize:om,denormalize:rm},rf=class rf{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};rf.prototype.isVector2=!0;var Ke=rf,Vn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],y=r[o+3];if(f!==y||l!==h||c!==d||u!==p){let g=l*h+c*d+u*p+f*y;g<0&&(h=-h,d=-d,p=-p,y=-y,g=-g);let m=1-a;if(g<.9995){let v=Math.acos(g),A=Math.sin(v);m=Math.sin(m*v)/A,a=Math.sin(a*v)/A,l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+y*a}else{l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},of=class of{constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Xd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Xd.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Yh.copy(this).projectOnVector(e),this.sub(Yh)}reflect(e){return this.sub(Yh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};of.prototype.isVector3=!0;var Y=of,Yh=new Y,Xd=new Vn,af=class af{constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],y=s[0],g=s[3],m=s[6],v=s[1],A=s[4],b=s[7],R=s[2],E=s[5],_=s[8];return r[0]=o*y+a*v+l*R,r[3]=o*g+a*A+l*E,r[6]=o*m+a*b+l*_,r[1]=c*y+u*v+f*R,r[4]=c*g+u*A+f*E,r[7]=c*m+u*b+f*_,r[2]=h*y+d*v+p*R,r[5]=h*g+d*A+p*E,r[8]=h*m+d*b+p*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return e[0]=f*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=d*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ea("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Zh.makeScale(e,t)),this}rotate(e){return ea("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Zh.makeRotation(-e)),this}translate(e,t){return ea("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Zh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}};af.prototype.isMatrix3=!0;var ot=af,Zh=new ot,qd=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Yd=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Mx(){let n={enabled:!0,workingColorSpace:sa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=bs(s.r),s.g=bs(s.g),s.b=bs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=so(s.r),s.g=so(s.g),s.b=so(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Rs?ra:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[sa]:{primaries:e,whitePoint:i,transfer:ra,toXYZ:qd,fromXYZ:Yd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:hi},outputColorSpaceConfig:{drawingBufferColorSpace:hi}},[hi]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:qd,fromXYZ:Yd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:hi}}}),n}var bt=Mx();function bs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function so(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var $r,Hl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{$r===void 0&&($r=oa("canvas")),$r.width=e.width,$r.height=e.height;let s=$r.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=$r}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=oa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=bs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(bs(t[i]/255)*255):t[i]=bs(t[i]);return{data:t,width:e.width,height:e.height}}else return je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},wx=0,co=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:wx++}),this.uuid=Mo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(jh(s[o].image)):r.push(jh(s[o]))}else r=jh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function jh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Hl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(je("Texture: Unable to serialize Texture."),{})}var Tx=0,Jh=new Y,Kn=class n extends Ni{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Ji,s=Ji,r=Jn,o=As,a=Bi,l=ni,c=n.DEFAULT_ANISOTROPY,u=Rs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Tx++}),this.uuid=Mo(),this.name="",this.source=new co(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Jh).x}get height(){return this.source.getSize(Jh).y}get depth(){return this.source.getSize(Jh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Ou)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case zl:e.x=e.x-Math.floor(e.x);break;case Ji:e.x=e.x<0?0:1;break;case Vl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case zl:e.y=e.y-Math.floor(e.y);break;case Ji:e.y=e.y<0?0:1;break;case Vl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=Ou;Kn.DEFAULT_ANISOTROPY=1;var lf=class lf{constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],y=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,b=(d+1)/2,R=(m+1)/2,E=(u+h)/4,_=(f+y)/4,T=(p+g)/4;return A>b&&A>R?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=E/i,r=_/i):b>R?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=E/s,r=T/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=T/r),this.set(i,s,r,t),this}let v=Math.sqrt((g-p)*(g-p)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(g-p)/v,this.y=(f-y)/v,this.z=(h-u)/v,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};lf.prototype.isVector4=!0;var Qt=lf,Wl=class extends Ni{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Qt(0,0,e,t),this.scissorTest=!1,this.viewport=new Qt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new co(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},fi=class extends Wl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},aa=class extends Kn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var $l=class extends Kn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var fc=class fc{constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,g)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=p,m[11]=y,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new fc().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Xr.setFromMatrixColumn(e,0).length(),r=1/Xr.setFromMatrixColumn(e,1).length(),o=1/Xr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,y=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-y*c,t[9]=-a*l,t[2]=y-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,y=c*f;t[0]=h+y*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=y+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,y=c*f;t[0]=h-y*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=y-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,y=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+y,t[1]=l*f,t[5]=y*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=y-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-y*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+y,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ex,e,Ax)}lookAt(e,t,i){let s=this.elements;return li.subVectors(e,t),li.lengthSq()===0&&(li.z=1),li.normalize(),ks.crossVectors(i,li),ks.lengthSq()===0&&(Math.abs(i.z)===1?li.x+=1e-4:li.z+=1e-4,li.normalize(),ks.crossVectors(i,li)),ks.normalize(),al.crossVectors(li,ks),s[0]=ks.x,s[4]=al.x,s[8]=li.x,s[1]=ks.y,s[5]=al.y,s[9]=li.y,s[2]=ks.z,s[6]=al.z,s[10]=li.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],y=i[6],g=i[10],m=i[14],v=i[3],A=i[7],b=i[11],R=i[15],E=s[0],_=s[4],T=s[8],V=s[12],F=s[1],L=s[5],D=s[9],G=s[13],P=s[2],W=s[6],O=s[10],N=s[14],j=s[3],$=s[7],Z=s[11],ne=s[15];return r[0]=o*E+a*F+l*P+c*j,r[4]=o*_+a*L+l*W+c*$,r[8]=o*T+a*D+l*O+c*Z,r[12]=o*V+a*G+l*N+c*ne,r[1]=u*E+f*F+h*P+d*j,r[5]=u*_+f*L+h*W+d*$,r[9]=u*T+f*D+h*O+d*Z,r[13]=u*V+f*G+h*N+d*ne,r[2]=p*E+y*F+g*P+m*j,r[6]=p*_+y*L+g*W+m*$,r[10]=p*T+y*D+g*O+m*Z,r[14]=p*V+y*G+g*N+m*ne,r[3]=v*E+A*F+b*P+R*j,r[7]=v*_+A*L+b*W+R*$,r[11]=v*T+A*D+b*O+R*Z,r[15]=v*V+A*G+b*N+R*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],y=e[7],g=e[11],m=e[15],v=l*d-c*h,A=a*d-c*f,b=a*h-l*f,R=o*d-c*u,E=o*h-l*u,_=o*f-a*u;return t*(y*v-g*A+m*b)-i*(p*v-g*R+m*E)+s*(p*A-y*R+m*_)-r*(p*b-y*E+g*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],y=e[13],g=e[14],m=e[15],v=t*a-i*o,A=t*l-s*o,b=t*c-r*o,R=i*l-s*a,E=i*c-r*a,_=s*c-r*l,T=u*y-f*p,V=u*g-h*p,F=u*m-d*p,L=f*g-h*y,D=f*m-d*y,G=h*m-d*g,P=v*G-A*D+b*L+R*F-E*V+_*T;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/P;return e[0]=(a*G-l*D+c*L)*W,e[1]=(s*D-i*G-r*L)*W,e[2]=(y*_-g*E+m*R)*W,e[3]=(h*E-f*_-d*R)*W,e[4]=(l*F-o*G-c*V)*W,e[5]=(t*G-s*F+r*V)*W,e[6]=(g*b-p*_-m*A)*W,e[7]=(u*_-h*b+d*A)*W,e[8]=(o*D-a*F+c*T)*W,e[9]=(i*F-t*D-r*T)*W,e[10]=(p*E-y*b+m*v)*W,e[11]=(f*b-u*E-d*v)*W,e[12]=(a*V-o*L-l*T)*W,e[13]=(t*L-i*V+s*T)*W,e[14]=(y*A-p*R-g*v)*W,e[15]=(u*R-f*A+h*v)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,y=o*u,g=o*f,m=a*f,v=l*c,A=l*u,b=l*f,R=i.x,E=i.y,_=i.z;return s[0]=(1-(y+m))*R,s[1]=(d+b)*R,s[2]=(p-A)*R,s[3]=0,s[4]=(d-b)*E,s[5]=(1-(h+m))*E,s[6]=(g+v)*E,s[7]=0,s[8]=(p+A)*_,s[9]=(g-v)*_,s[10]=(1-(h+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Xr.set(s[0],s[1],s[2]).length(),a=Xr.set(s[4],s[5],s[6]).length(),l=Xr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Pi.copy(this);let c=1/o,u=1/a,f=1/l;return Pi.elements[0]*=c,Pi.elements[1]*=c,Pi.elements[2]*=c,Pi.elements[4]*=u,Pi.elements[5]*=u,Pi.elements[6]*=u,Pi.elements[8]*=f,Pi.elements[9]*=f,Pi.elements[10]*=f,t.setFromRotationMatrix(Pi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Si,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===Si)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===oo)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Si,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===Si)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===oo)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}};fc.prototype.isMatrix4=!0;var zt=fc,Xr=new Y,Pi=new zt,Ex=new Y(0,0,0),Ax=new Y(1,1,1),ks=new Y,al=new Y,li=new Y,Zd=new zt,jd=new Vn,ws=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Zd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Zd,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return jd.setFromEuler(this),this.setFromQuaternion(jd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ws.DEFAULT_ORDER="XYZ";var ho=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Cx=0,Jd=new Y,qr=new Vn,_s=new zt,ll=new Y,Zo=new Y,Rx=new Y,Px=new Vn,Kd=new Y(1,0,0),Qd=new Y(0,1,0),ep=new Y(0,0,1),tp={type:"added"},Ix={type:"removed"},Yr={type:"childadded",child:null},Kh={type:"childremoved",child:null},Dn=class n extends Ni{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Cx++}),this.uuid=Mo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Y,t=new ws,i=new Vn,s=new Y(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new zt},normalMatrix:{value:new ot}}),this.matrix=new zt,this.matrixWorld=new zt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ho,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return qr.setFromAxisAngle(e,t),this.quaternion.multiply(qr),this}rotateOnWorldAxis(e,t){return qr.setFromAxisAngle(e,t),this.quaternion.premultiply(qr),this}rotateX(e){return this.rotateOnAxis(Kd,e)}rotateY(e){return this.rotateOnAxis(Qd,e)}rotateZ(e){return this.rotateOnAxis(ep,e)}translateOnAxis(e,t){return Jd.copy(e).applyQuaternion(this.quaternion),this.position.add(Jd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Kd,e)}translateY(e){return this.translateOnAxis(Qd,e)}translateZ(e){return this.translateOnAxis(ep,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(_s.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ll.copy(e):ll.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Zo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_s.lookAt(Zo,ll,this.up):_s.lookAt(ll,Zo,this.up),this.quaternion.setFromRotationMatrix(_s),s&&(_s.extractRotation(s.matrixWorld),qr.setFromRotationMatrix(_s),this.quaternion.premultiply(qr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(tp),Yr.child=e,this.dispatchEvent(Yr),Yr.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ix),Kh.child=e,this.dispatchEvent(Kh),Kh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),_s.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),_s.multiply(e.parent.matrixWorld)),e.applyMatrix4(_s),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(tp),Yr.child=e,this.dispatchEvent(Yr),Yr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zo,e,Rx),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zo,Px,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new Y(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Di=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Lx={type:"move"},uo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Di,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Di,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Di,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let g=t.getJointPose(y,i),m=this._getHandJoint(c,y);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Lx)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Di;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},am={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zs={h:0,s:0,l:0},cl={h:0,s:0,l:0};function Qh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ut=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=hi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=i,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=bt.workingColorSpace){if(e=ju(e,1),t=yt(t,0,1),i=yt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Qh(o,r,e+1/3),this.g=Qh(o,r,e),this.b=Qh(o,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=hi){function i(r){r!==void 0&&parseFloat(r)<1&&je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=hi){let i=am[e.toLowerCase()];return i!==void 0?this.setHex(i,t):je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=bs(e.r),this.g=bs(e.g),this.b=bs(e.b),this}copyLinearToSRGB(e){return this.r=so(e.r),this.g=so(e.g),this.b=so(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=hi){return bt.workingToColorSpace(zn.copy(this),e),Math.round(yt(zn.r*255,0,255))*65536+Math.round(yt(zn.g*255,0,255))*256+Math.round(yt(zn.b*255,0,255))}getHexString(e=hi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(zn.copy(this),t);let i=zn.r,s=zn.g,r=zn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=hi){bt.workingToColorSpace(zn.copy(this),e);let t=zn.r,i=zn.g,s=zn.b;return e!==hi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(zs),this.setHSL(zs.h+e,zs.s+t,zs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(zs),e.getHSL(cl);let i=na(zs.h,cl.h,t),s=na(zs.s,cl.s,t),r=na(zs.l,cl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new ut;ut.NAMES=am;var la=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ws,this.environmentIntensity=1,this.environmentRotation=new ws,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ii=new Y,xs=new Y,eu=new Y,ys=new Y,Zr=new Y,jr=new Y,np=new Y,tu=new Y,nu=new Y,iu=new Y,su=new Qt,ru=new Qt,ou=new Qt,Ws=class n{constructor(e=new Y,t=new Y,i=new Y){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ii.subVectors(e,t),s.cross(Ii);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ii.subVectors(s,t),xs.subVectors(i,t),eu.subVectors(e,t);let o=Ii.dot(Ii),a=Ii.dot(xs),l=Ii.dot(eu),c=xs.dot(xs),u=xs.dot(eu),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ys)===null?!1:ys.x>=0&&ys.y>=0&&ys.x+ys.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ys)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ys.x),l.addScaledVector(o,ys.y),l.addScaledVector(a,ys.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return su.setScalar(0),ru.setScalar(0),ou.setScalar(0),su.fromBufferAttribute(e,t),ru.fromBufferAttribute(e,i),ou.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(su,r.x),o.addScaledVector(ru,r.y),o.addScaledVector(ou,r.z),o}static isFrontFacing(e,t,i,s){return Ii.subVectors(i,t),xs.subVectors(e,t),Ii.cross(xs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ii.subVectors(this.c,this.b),xs.subVectors(this.a,this.b),Ii.cross(xs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Zr.subVectors(s,i),jr.subVectors(r,i),tu.subVectors(e,i);let l=Zr.dot(tu),c=jr.dot(tu);if(l<=0&&c<=0)return t.copy(i);nu.subVectors(e,s);let u=Zr.dot(nu),f=jr.dot(nu);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Zr,o);iu.subVectors(e,r);let d=Zr.dot(iu),p=jr.dot(iu);if(p>=0&&d<=p)return t.copy(r);let y=d*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(jr,a);let g=u*p-d*f;if(g<=0&&f-u>=0&&d-p>=0)return np.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(np,a);let m=1/(g+y+h);return o=y*m,a=h*m,t.copy(i).addScaledVector(Zr,o).addScaledVector(jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},$s=class{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Li.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Li.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Li.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Li):Li.fromBufferAttribute(r,o),Li.applyMatrix4(e.matrixWorld),this.expandByPoint(Li);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),hl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),hl.copy(i.boundingBox)),hl.applyMatrix4(e.matrixWorld),this.union(hl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Li),Li.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(jo),ul.subVectors(this.max,jo),Jr.subVectors(e.a,jo),Kr.subVectors(e.b,jo),Qr.subVectors(e.c,jo),Vs.subVectors(Kr,Jr),Gs.subVectors(Qr,Kr),dr.subVectors(Jr,Qr);let t=[0,-Vs.z,Vs.y,0,-Gs.z,Gs.y,0,-dr.z,dr.y,Vs.z,0,-Vs.x,Gs.z,0,-Gs.x,dr.z,0,-dr.x,-Vs.y,Vs.x,0,-Gs.y,Gs.x,0,-dr.y,dr.x,0];return!au(t,Jr,Kr,Qr,ul)||(t=[1,0,0,0,1,0,0,0,1],!au(t,Jr,Kr,Qr,ul))?!1:(fl.crossVectors(Vs,Gs),t=[fl.x,fl.y,fl.z],au(t,Jr,Kr,Qr,ul))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Li).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Li).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(vs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),vs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),vs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),vs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),vs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),vs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),vs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),vs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(vs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},vs=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Li=new Y,hl=new $s,Jr=new Y,Kr=new Y,Qr=new Y,Vs=new Y,Gs=new Y,dr=new Y,jo=new Y,ul=new Y,fl=new Y,pr=new Y;function au(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){pr.fromArray(n,r);let a=s.x*Math.abs(pr.x)+s.y*Math.abs(pr.y)+s.z*Math.abs(pr.z),l=e.dot(pr),c=t.dot(pr),u=i.dot(pr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var gn=new Y,dl=new Ke,Dx=0,Ki=class extends Ni{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Dx++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=em,this.updateRanges=[],this.gpuType=Fi,this.version=0,this._normalizationScale=e!==void 0?Ku(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)dl.fromBufferAttribute(this,t),dl.applyMatrix3(e),this.setXY(t,dl.x,dl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):rm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):om(e,this.array)}};var ca=class extends Ki{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ha=class extends Ki{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Bt=class extends Ki{constructor(e,t,i){super(new Float32Array(e),t,i)}},Nx=new $s,Jo=new Y,lu=new Y,Xs=class{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Nx.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Jo.subVectors(e,this.center);let t=Jo.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Jo,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(lu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Jo.copy(e.center).add(lu)),this.expandByPoint(Jo.copy(e.center).sub(lu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Ux=0,vi=new zt,cu=new Dn,eo=new Y,ci=new $s,Ko=new $s,In=new Y,vn=class n extends Ni{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ux++}),this.uuid=Mo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ox(e)?ha:ca)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ot().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return vi.makeRotationFromQuaternion(e),this.applyMatrix4(vi),this}rotateX(e){return vi.makeRotationX(e),this.applyMatrix4(vi),this}rotateY(e){return vi.makeRotationY(e),this.applyMatrix4(vi),this}rotateZ(e){return vi.makeRotationZ(e),this.applyMatrix4(vi),this}translate(e,t,i){return vi.makeTranslation(e,t,i),this.applyMatrix4(vi),this}scale(e,t,i){return vi.makeScale(e,t,i),this.applyMatrix4(vi),this}lookAt(e){return cu.lookAt(e),cu.updateMatrix(),this.applyMatrix4(cu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(eo).negate(),this.translate(eo.x,eo.y,eo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Bt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new $s);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ci.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,ci.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,ci.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(ci.min),this.boundingBox.expandByPoint(ci.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Xs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){let i=this.boundingSphere.center;if(ci.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ko.setFromBufferAttribute(a),this.morphTargetsRelative?(In.addVectors(ci.min,Ko.min),ci.expandByPoint(In),In.addVectors(ci.max,Ko.max),ci.expandByPoint(In)):(ci.expandByPoint(Ko.min),ci.expandByPoint(Ko.max))}ci.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)In.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(In));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)In.fromBufferAttribute(a,c),l&&(eo.fromBufferAttribute(e,c),In.add(eo)),s=Math.max(s,i.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ki(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let V=0;V<i.count;V++)a[V]=new Y,l[V]=new Y;let u=new Y,f=new Y,h=new Y,d=new Ke,p=new Ke,y=new Ke,g=new Y,m=new Y;function v(V,F,L){c[V]=c[F]=c[L]=1,u.fromBufferAttribute(i,V),f.fromBufferAttribute(i,F),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,V),p.fromBufferAttribute(r,F),y.fromBufferAttribute(r,L),f.sub(u),h.sub(u),p.sub(d),y.sub(d);let D=1/(p.x*y.y-y.x*p.y);isFinite(D)&&(g.copy(f).multiplyScalar(y.y).addScaledVector(h,-p.y).multiplyScalar(D),m.copy(h).multiplyScalar(p.x).addScaledVector(f,-y.x).multiplyScalar(D),a[V].add(g),a[F].add(g),a[L].add(g),l[V].add(m),l[F].add(m),l[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let V=0,F=A.length;V<F;++V){let L=A[V],D=L.start,G=L.count;for(let P=D,W=D+G;P<W;P+=3)v(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let b=new Y,R=new Y,E=new Y,_=new Y;function T(V){E.fromBufferAttribute(s,V),_.copy(E);let F=a[V];b.copy(F),b.sub(E.multiplyScalar(E.dot(F))).normalize(),R.crossVectors(_,F);let D=R.dot(l[V])<0?-1:1;o.setXYZW(V,b.x,b.y,b.z,D)}for(let V=0,F=i.count;V<F;++V)c[V]&&T(V);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Ki(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,u=new Y,f=new Y;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),y=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)In.fromBufferAttribute(e,t),In.normalize(),e.setXYZ(t,In.x,In.y,In.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let m=0;m<u;m++)h[p++]=c[d++]}return new Ki(h,u,f)}if(this.index===null)return je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var hu=new Y,Fx=new Y,Ox=new ot,ui=class{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=hu.subVectors(i,t).cross(Fx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(hu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Ox.getNormalMatrix(e),s=this.coplanarPoint(hu).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Bx=0,Qi=class extends Ni{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Bx++}),this.uuid=Mo(),this.name="",this.type="Material",this.blending=vo,this.side=tr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Cu,this.blendDst=Ru,this.blendEquation=yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ut(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Yp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ll,this.stencilZFail=Ll,this.stencilZPass=Ll,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ut().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ui().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ss=new Y,uu=new Y,pl=new Y,ml=new Y,Ts=class{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ss)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ss.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ss.copy(this.origin).addScaledVector(this.direction,t),Ss.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){uu.copy(e).add(t).multiplyScalar(.5),pl.copy(t).sub(e).normalize(),ml.copy(this.origin).sub(uu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(pl),a=ml.dot(this.direction),l=-ml.dot(pl),c=ml.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let y=1/u;f*=y,h*=y,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(uu).addScaledVector(pl,h),d}intersectSphere(e,t){if(e.radius<0)return null;Ss.subVectors(e.center,this.origin);let i=Ss.dot(this.direction),s=Ss.dot(Ss)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Ss)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,y=t.y-o.y,g=t.z-o.z,m=i.x-o.x,v=i.y-o.y,A=i.z-o.z,b=Math.abs(l),R=Math.abs(c),E=Math.abs(u),_,T,V,F,L,D,G,P,W,O,N,j;if(b>=R&&b>=E?(V=l,D=f,W=p,j=m,l>=0?(_=c,T=u,F=h,L=d,G=y,P=g,O=v,N=A):(_=u,T=c,F=d,L=h,G=g,P=y,O=A,N=v)):R>=E?(V=c,D=h,W=y,j=v,c>=0?(_=u,T=l,F=d,L=f,G=g,P=p,O=A,N=m):(_=l,T=u,F=f,L=d,G=p,P=g,O=m,N=A)):(V=u,D=d,W=g,j=A,u>=0?(_=l,T=c,F=f,L=h,G=p,P=y,O=m,N=v):(_=c,T=l,F=h,L=f,G=y,P=p,O=v,N=m)),V===0)return null;let $=_/V,Z=T/V,ne=1/V,fe=F-$*D,ue=L-Z*D,te=G-$*W,ge=P-Z*W,ye=O-$*j,Ce=N-Z*j,Me=ye*ge-Ce*te,$e=fe*Ce-ue*ye,ct=te*ue-ge*fe;if(s){if(Me<0||$e<0||ct<0)return null}else if((Me<0||$e<0||ct<0)&&(Me>0||$e>0||ct>0))return null;let He=Me+$e+ct;if(He===0)return null;let gt=ne*(Me*D+$e*W+ct*j);return(He>0?gt<0:gt>0)?null:this.at(gt/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xl=class extends Qi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ws,this.combine=dc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},ip=new zt,mr=new Ts,gl=new Xs,sp=new Y,_l=new Y,xl=new Y,yl=new Y,fu=new Y,vl=new Y,rp=new Y,Sl=new Y,bi=class extends Dn{constructor(e=new vn,t=new Xl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){vl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(fu.fromBufferAttribute(f,e),o?vl.addScaledVector(fu,u):vl.addScaledVector(fu.sub(t),u))}t.add(vl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),gl.copy(i.boundingSphere),gl.applyMatrix4(r),mr.copy(e.ray).recast(e.near),!(gl.containsPoint(mr.origin)===!1&&(mr.intersectSphere(gl,sp)===null||mr.origin.distanceToSquared(sp)>(e.far-e.near)**2))&&(ip.copy(r).invert(),mr.copy(e.ray).applyMatrix4(ip),!(i.boundingBox!==null&&mr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,mr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=h.length;p<y;p++){let g=h[p],m=o[g.materialIndex],v=Math.max(g.start,d.start),A=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let b=v,R=A;b<R;b+=3){let E=a.getX(b),_=a.getX(b+1),T=a.getX(b+2);s=bl(this,m,e,i,c,u,f,E,_,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=p,m=y;g<m;g+=3){let v=a.getX(g),A=a.getX(g+1),b=a.getX(g+2);s=bl(this,o,e,i,c,u,f,v,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=h.length;p<y;p++){let g=h[p],m=o[g.materialIndex],v=Math.max(g.start,d.start),A=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let b=v,R=A;b<R;b+=3){let E=b,_=b+1,T=b+2;s=bl(this,m,e,i,c,u,f,E,_,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let g=p,m=y;g<m;g+=3){let v=g,A=g+1,b=g+2;s=bl(this,o,e,i,c,u,f,v,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function kx(n,e,t,i,s,r,o,a){let l;if(e.side===Qn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===tr,a),l===null)return null;Sl.copy(a),Sl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Sl);return c<t.near||c>t.far?null:{distance:c,point:Sl.clone(),object:n}}function bl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,_l),n.getVertexPosition(l,xl),n.getVertexPosition(c,yl);let u=kx(n,e,t,i,_l,xl,yl,rp);if(u){let f=new Y;Ws.getBarycoord(rp,_l,xl,yl,f),s&&(u.uv=Ws.getInterpolatedAttribute(s,a,l,c,f,new Ke)),r&&(u.uv1=Ws.getInterpolatedAttribute(r,a,l,c,f,new Ke)),o&&(u.normal=Ws.getInterpolatedAttribute(o,a,l,c,f,new Y),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new Y,materialIndex:0};Ws.getNormal(_l,xl,yl,h.normal),u.face=h,u.barycoord=f}return u}var ql=class extends Kn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Ln,u=Ln,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var gr=new Xs,zx=new Ke(.5,.5),Ml=new Y,qs=class{constructor(e=new ui,t=new ui,i=new ui,s=new ui,r=new ui,o=new ui){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Si,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],y=r[9],g=r[10],m=r[11],v=r[12],A=r[13],b=r[14],R=r[15];if(s[0].setComponents(c-o,d-u,m-p,R-v).normalize(),s[1].setComponents(c+o,d+u,m+p,R+v).normalize(),s[2].setComponents(c+a,d+f,m+y,R+A).normalize(),s[3].setComponents(c-a,d-f,m-y,R-A).normalize(),i)s[4].setComponents(l,h,g,b).normalize(),s[5].setComponents(c-l,d-h,m-g,R-b).normalize();else if(s[4].setComponents(c-l,d-h,m-g,R-b).normalize(),t===Si)s[5].setComponents(c+l,d+h,m+g,R+b).normalize();else if(t===oo)s[5].setComponents(l,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),gr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),gr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(gr)}intersectsSprite(e){gr.center.set(0,0,0);let t=zx.distanceTo(e.center);return gr.radius=.7071067811865476+t,gr.applyMatrix4(e.matrixWorld),this.intersectsSphere(gr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Ml.x=s.normal.x>0?e.max.x:e.min.x,Ml.y=s.normal.y>0?e.max.y:e.min.y,Ml.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ml)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},op=new zt,Yl=class n{constructor(){this.coordinateSystem=Si,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];op.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new qs),i[s].setFromProjectionMatrix(op,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new qs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var es=class extends Qi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Zl=new Y,jl=new Y,ap=new zt,Qo=new Ts,wl=new Xs,du=new Y,lp=new Y,fo=class extends Dn{constructor(e=new vn,t=new es){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Zl.fromBufferAttribute(t,s-1),jl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Zl.distanceTo(jl);e.setAttribute("lineDistance",new Bt(i,1))}else je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),wl.copy(i.boundingSphere),wl.applyMatrix4(s),wl.radius+=r,e.ray.intersectsSphere(wl)===!1)return;ap.copy(s).invert(),Qo.copy(e.ray).applyMatrix4(ap);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=d,g=p-1;y<g;y+=c){let m=u.getX(y),v=u.getX(y+1),A=Tl(this,e,Qo,l,m,v,y);A&&t.push(A)}if(this.isLineLoop){let y=u.getX(p-1),g=u.getX(d),m=Tl(this,e,Qo,l,y,g,p-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let y=d,g=p-1;y<g;y+=c){let m=Tl(this,e,Qo,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Tl(this,e,Qo,l,p-1,d,p-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Tl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Zl.fromBufferAttribute(a,s),jl.fromBufferAttribute(a,r),t.distanceSqToSegment(Zl,jl,du,lp)>i)return;du.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(du);if(!(c<e.near||c>e.far))return{distance:c,point:lp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var cp=new Y,hp=new Y,Ys=class extends fo{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)cp.fromBufferAttribute(t,s),hp.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+cp.distanceTo(hp);e.setAttribute("lineDistance",new Bt(i,1))}else je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var _r=class extends Qi{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ut(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},up=new zt,yu=new Ts,El=new Xs,Al=new Y,po=class extends Dn{constructor(e=new vn,t=new _r){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),El.copy(i.boundingSphere),El.applyMatrix4(s),El.radius+=r,e.ray.intersectsSphere(El)===!1)return;up.copy(s).invert(),yu.copy(e.ray).applyMatrix4(up);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=h,y=d;p<y;p++){let g=c.getX(p);Al.fromBufferAttribute(f,g),fp(Al,g,l,s,e,t,this)}}else{let h=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let p=h,y=d;p<y;p++)Al.fromBufferAttribute(f,p),fp(Al,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function fp(n,e,t,i,s,r,o){let a=yu.distanceSqToPoint(n);if(a<t){let l=new Y;yu.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var ua=class extends Kn{constructor(e=[],t=vr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},fa=class extends Kn{constructor(e,t,i,s,r,o,a,l,c){super(e,t,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Es=class extends Kn{constructor(e,t,i=Ui,s,r,o,a=Ln,l=Ln,c,u=Ms,f=1){if(u!==Ms&&u!==Cs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new co(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},da=class extends Es{constructor(e,t=Ui,i=vr,s,r,o=Ln,a=Ln,l,c=Ms){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},pa=class extends Kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Zs=class n extends vn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Bt(c,3)),this.setAttribute("normal",new Bt(u,3)),this.setAttribute("uv",new Bt(f,2));function p(y,g,m,v,A,b,R,E,_,T,V){let F=b/_,L=R/T,D=b/2,G=R/2,P=E/2,W=_+1,O=T+1,N=0,j=0,$=new Y;for(let Z=0;Z<O;Z++){let ne=Z*L-G;for(let fe=0;fe<W;fe++){let ue=fe*F-D;$[y]=ue*v,$[g]=ne*A,$[m]=P,c.push($.x,$.y,$.z),$[y]=0,$[g]=0,$[m]=E>0?1:-1,u.push($.x,$.y,$.z),f.push(fe/_),f.push(1-Z/T),N+=1}}for(let Z=0;Z<T;Z++)for(let ne=0;ne<_;ne++){let fe=h+ne+W*Z,ue=h+ne+W*(Z+1),te=h+(ne+1)+W*(Z+1),ge=h+(ne+1)+W*Z;l.push(fe,ue,ge),l.push(ue,te,ge),j+=6}a.addGroup(d,j,V),d+=j,h+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var mo=class n extends vn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],d=[],p=0,y=[],g=i/2,m=0;v(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new Bt(f,3)),this.setAttribute("normal",new Bt(h,3)),this.setAttribute("uv",new Bt(d,2));function v(){let b=new Y,R=new Y,E=0,_=(t-e)/i;for(let T=0;T<=r;T++){let V=[],F=T/r,L=F*(t-e)+e;for(let D=0;D<=s;D++){let G=D/s,P=G*l+a,W=Math.sin(P),O=Math.cos(P);R.x=L*W,R.y=-F*i+g,R.z=L*O,f.push(R.x,R.y,R.z),b.set(W,_,O).normalize(),h.push(b.x,b.y,b.z),d.push(G,1-F),V.push(p++)}y.push(V)}for(let T=0;T<s;T++)for(let V=0;V<r;V++){let F=y[V][T],L=y[V+1][T],D=y[V+1][T+1],G=y[V][T+1];(e>0||V!==0)&&(u.push(F,L,G),E+=3),(t>0||V!==r-1)&&(u.push(L,D,G),E+=3)}c.addGroup(m,E,0),m+=E}function A(b){let R=p,E=new Ke,_=new Y,T=0,V=b===!0?e:t,F=b===!0?1:-1;for(let D=1;D<=s;D++)f.push(0,g*F,0),h.push(0,F,0),d.push(.5,.5),p++;let L=p;for(let D=0;D<=s;D++){let P=D/s*l+a,W=Math.cos(P),O=Math.sin(P);_.x=V*O,_.y=g*F,_.z=V*W,f.push(_.x,_.y,_.z),h.push(0,F,0),E.x=W*.5+.5,E.y=O*.5*F+.5,d.push(E.x,E.y),p++}for(let D=0;D<s;D++){let G=R+D,P=L+D;b===!0?u.push(P,P+1,G):u.push(P+1,P,G),T+=3}c.addGroup(m,T,b===!0?1:2),m+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var ma=class n extends vn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],y=[],g=[];for(let m=0;m<u;m++){let v=m*h-o;for(let A=0;A<c;A++){let b=A*f-r;p.push(b,-v,0),y.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let A=v+c*m,b=v+c*(m+1),R=v+1+c*(m+1),E=v+1+c*m;d.push(A,b,E),d.push(b,R,E)}this.setIndex(d),this.setAttribute("position",new Bt(p,3)),this.setAttribute("normal",new Bt(y,3)),this.setAttribute("uv",new Bt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ga=class n extends vn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new Y,h=new Y,d=[],p=[],y=[],g=[];for(let m=0;m<=i;m++){let v=[],A=m/i,b=o+A*a,R=e*Math.cos(b),E=Math.sqrt(e*e-R*R),_=0;m===0&&o===0?_=.5/t:m===i&&l===Math.PI&&(_=-.5/t);for(let T=0;T<=t;T++){let V=T/t,F=s+V*r;f.x=-E*Math.cos(F),f.y=R,f.z=E*Math.sin(F),p.push(f.x,f.y,f.z),h.copy(f).normalize(),y.push(h.x,h.y,h.z),g.push(V+_,1-A),v.push(c++)}u.push(v)}for(let m=0;m<i;m++)for(let v=0;v<t;v++){let A=u[m][v+1],b=u[m][v],R=u[m+1][v],E=u[m+1][v+1];(m!==0||o>0)&&d.push(A,b,E),(m!==i-1||l<Math.PI)&&d.push(b,R,E)}this.setIndex(d),this.setAttribute("position",new Bt(p,3)),this.setAttribute("normal",new Bt(y,3)),this.setAttribute("uv",new Bt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function br(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(dp(s))s.isRenderTargetTexture?(je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(dp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Gn(n){let e={};for(let t=0;t<n.length;t++){let i=br(n[t]);for(let s in i)e[s]=i[s]}return e}function dp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Vx(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function ef(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var lm={clone:br,merge:Gn},Gx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Hx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ts=class extends Qi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Gx,this.fragmentShader=Hx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=br(e.uniforms),this.uniformsGroups=Vx(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ut().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ot().fromArray(s.value);break;case"m4":this.uniforms[i].value=new zt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Jl=class extends ts{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var go=class extends Qi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Qc,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ws,this.combine=dc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Kl=class extends Qi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Xp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ql=class extends Qi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function to(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Cl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var js=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ec=class extends js{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gu,endingEnd:gu}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case _u:r=e,a=2*t-i;break;case xu:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case _u:o=e,l=2*i-t;break;case xu:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),y=p*p,g=y*p,m=-h*g+2*h*y-h*p,v=(1+h)*g+(-1.5-2*h)*y+(-.5+h)*p+1,A=(-1-d)*g+(1.5+d)*y+.5*p,b=d*g-d*y;for(let R=0;R!==a;++R)r[R]=m*o[u+R]+v*o[c+R]+A*o[l+R]+b*o[f+R];return r}},tc=class extends js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},nc=class extends js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ic=class extends js{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),y=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*y+o[l+g]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let y=o[c+p],g=o[l+p],m=d*h+p*2,v=f[m],A=f[m+1],b=e*h+p*2,R=u[b],E=u[b+1],_=$x(i,t,v,R,s);r[p]=cm(_,y,A,E,g)}return r}};function cm(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function Wx(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function $x(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=cm(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Wx(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var di=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=to(t,this.TimeBufferType),this.values=to(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:to(e.times,Array),values:to(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Cl(e.settings)&&(i.settings={inTangents:to(e.settings.inTangents,Array),outTangents:to(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new nc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ic(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ia:t=this.InterpolantFactoryMethodDiscrete;break;case Gl:t=this.InterpolantFactoryMethodLinear;break;case Il:t=this.InterpolantFactoryMethodSmooth;break;case mu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ia;case this.InterpolantFactoryMethodLinear:return Gl;case this.InterpolantFactoryMethodSmooth:return Il;case this.InterpolantFactoryMethodBezier:return mu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Cl(this.settings)&&(pp(this.settings.inTangents,e),pp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Cl(this.settings)&&(mp(this.settings.inTangents,e),mp(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&ax(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Il,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let y=t[f+p];if(y!==t[h+p]||y!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Cl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function pp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function mp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}di.prototype.ValueTypeName="";di.prototype.TimeBufferType=Float32Array;di.prototype.ValueBufferType=Float32Array;di.prototype.DefaultInterpolation=Gl;var Js=class extends di{constructor(e,t,i){super(e,t,i)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=ia;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var sc=class extends di{constructor(e,t,i,s){super(e,t,i,s)}};sc.prototype.ValueTypeName="color";var rc=class extends di{constructor(e,t,i,s){super(e,t,i,s)}};rc.prototype.ValueTypeName="number";var oc=class extends js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Vn.slerpFlat(r,0,o,c-a,o,c,l);return r}},_a=class extends di{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new oc(this.times,this.values,this.getValueSize(),e)}};_a.prototype.ValueTypeName="quaternion";_a.prototype.InterpolantFactoryMethodSmooth=void 0;var Ks=class extends di{constructor(e,t,i){super(e,t,i)}};Ks.prototype.ValueTypeName="string";Ks.prototype.ValueBufferType=Array;Ks.prototype.DefaultInterpolation=ia;Ks.prototype.InterpolantFactoryMethodLinear=void 0;Ks.prototype.InterpolantFactoryMethodSmooth=void 0;var ac=class extends di{constructor(e,t,i,s){super(e,t,i,s)}};ac.prototype.ValueTypeName="vector";var lc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},hm=new lc,cc=class{constructor(e){this.manager=e!==void 0?e:hm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};cc.DEFAULT_MATERIAL_NAME="__DEFAULT";var xa=class extends Dn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ut(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ya=class extends xa{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ut(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},pu=new zt,gp=new Y,_p=new Y,hc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=ni,this.map=null,this.mapPass=null,this.matrix=new zt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new qs,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Qt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;gp.setFromMatrixPosition(e.matrixWorld),t.position.copy(gp),_p.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(_p),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){pu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(pu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===oo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(pu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Rl=new Y,Pl=new Vn,ji=new Y,va=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new zt,this.projectionMatrix=new zt,this.projectionMatrixInverse=new zt,this.coordinateSystem=Si,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Rl,Pl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Rl,Pl,ji.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Rl,Pl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Rl,Pl,ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Hs=new Y,xp=new Ke,yp=new Ke,jn=class extends va{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=lo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ta*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return lo*2*Math.atan(Math.tan(ta*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Hs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Hs.x,Hs.y).multiplyScalar(-e/Hs.z),Hs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Hs.x,Hs.y).multiplyScalar(-e/Hs.z)}getViewSize(e,t){return this.getViewBounds(e,xp,yp),t.subVectors(yp,xp)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ta*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Sa=class extends va{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},vu=class extends hc{constructor(){super(new Sa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ba=class extends xa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new vu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var no=-90,io=1,_o=class extends Dn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(no,io,e,t);s.layers=this.layers,this.add(s);let r=new jn(no,io,e,t);r.layers=this.layers,this.add(r);let o=new jn(no,io,e,t);o.layers=this.layers,this.add(o);let a=new jn(no,io,e,t);a.layers=this.layers,this.add(a);let l=new jn(no,io,e,t);l.layers=this.layers,this.add(l);let c=new jn(no,io,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Si)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===oo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},uc=class extends jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var tf="\\[\\]\\.:\\/",Xx=new RegExp("["+tf+"]","g"),nf="[^"+tf+"]",qx="[^"+tf.replace("\\.","")+"]",Yx=/((?:WC+[\/:])*)/.source.replace("WC",nf),Zx=/(WCOD+)?/.source.replace("WCOD",qx),jx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nf),Jx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nf),Kx=new RegExp("^"+Yx+Zx+jx+Jx+"$"),Qx=["material","materials","bones","map"],Su=class{constructor(e,t,i){let s=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Xx,"")}static parseTrackName(e){let t=Kx.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Qx.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Su;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var B1=new Float32Array(1);var vp=new zt,Ma=class{constructor(e,t,i=0,s=1/0){this.ray=new Ts(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ho,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):it("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return vp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(vp),this}intersectObject(e,t=!0,i=[]){return bu(e,this,i,t),i.sort(Sp),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)bu(e[s],this,i,t);return i.sort(Sp),i}};function Sp(n,e){return n.distance-e.distance}function bu(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)bu(r[o],e,t,!0)}}var xo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var cf=class cf{constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};cf.prototype.isMatrix2=!0;var Mu=cf;var wa=class extends Ys{constructor(e=10,t=10,i=4473924,s=8947848){i=new ut(i),s=new ut(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let h=0,d=0,p=-a;h<=t;h++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let y=h===r?i:s;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let u=new vn;u.setAttribute("position",new Bt(l,3)),u.setAttribute("color",new Bt(c,3));let f=new es({vertexColors:!0,toneMapped:!1});super(u,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ta=class extends Ni{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function sf(n,e,t,i){let s=ey(i);switch(t){case Gu:return n*e;case Wu:return n*e/s.components*s.byteLength;case vc:return n*e/s.components*s.byteLength;case nr:return n*e*2/s.components*s.byteLength;case Sc:return n*e*2/s.components*s.byteLength;case Hu:return n*e*3/s.components*s.byteLength;case Bi:return n*e*4/s.components*s.byteLength;case bc:return n*e*4/s.components*s.byteLength;case Ca:case Ra:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Pa:case Ia:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case wc:case Ec:return Math.max(n,16)*Math.max(e,8)/4;case Mc:case Tc:return Math.max(n,8)*Math.max(e,8)/2;case Ac:case Cc:case Pc:case Ic:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Rc:case La:case Lc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Dc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Nc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Uc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Oc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Bc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case kc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case zc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Vc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Gc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Hc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Wc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case $c:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Xc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case qc:case Yc:case Zc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case jc:case Jc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Da:case Kc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function ey(n){switch(n){case ni:case Bu:return{byteLength:1,components:1};case bo:case ku:case Oi:return{byteLength:2,components:1};case xc:case yc:return{byteLength:2,components:4};case Ui:case _c:case Fi:return{byteLength:4,components:1};case zu:case Vu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lm(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function ny(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],y=f[d];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++h,f[h]=y)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let y=f[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var iy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,sy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,ry=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,oy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ay=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ly=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,cy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,hy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,uy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,fy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,dy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,py=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,my=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,gy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,_y=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,xy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,yy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,vy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Sy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,by=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,My=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,wy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Ty=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Ey=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Ay=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Cy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ry=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Py=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Iy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ly="gl_FragColor = linearToOutputTexel( gl_FragColor );",Dy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ny=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Uy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Fy=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Oy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,By=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,ky=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,zy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Vy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Gy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Hy=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Wy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,$y=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Xy=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,qy=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Yy=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Zy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,jy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Jy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ky=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Qy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,ev=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,tv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,nv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,iv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,sv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,rv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ov=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,av=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,cv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,hv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,uv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,fv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,dv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,pv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,mv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,gv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,_v=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,yv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,vv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Sv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,bv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Mv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Tv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ev=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Av=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Cv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Rv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Pv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Iv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Lv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Dv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Nv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Uv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Fv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Ov=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Bv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,kv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,zv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Vv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Gv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Hv=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Wv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,$v=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Xv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,qv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Yv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Zv=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,jv=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Jv=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Kv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Qv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,eS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,tS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,nS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,iS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,rS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,oS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,aS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,cS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,hS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,uS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,fS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,dS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,mS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,gS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,_S=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,SS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,MS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,wS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,TS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ES=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,AS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,CS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,RS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,IS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,LS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,NS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,US=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,mt={alphahash_fragment:iy,alphahash_pars_fragment:sy,alphamap_fragment:ry,alphamap_pars_fragment:oy,alphatest_fragment:ay,alphatest_pars_fragment:ly,aomap_fragment:cy,aomap_pars_fragment:hy,batching_pars_vertex:uy,batching_vertex:fy,begin_vertex:dy,beginnormal_vertex:py,bsdfs:my,iridescence_fragment:gy,bumpmap_pars_fragment:_y,clipping_planes_fragment:xy,clipping_planes_pars_fragment:yy,clipping_planes_pars_vertex:vy,clipping_planes_vertex:Sy,color_fragment:by,color_pars_fragment:My,color_pars_vertex:wy,color_vertex:Ty,common:Ey,defaultnormal_vertex:Ay,displacementmap_pars_vertex:Cy,displacementmap_vertex:Ry,emissivemap_fragment:Py,emissivemap_pars_fragment:Iy,colorspace_fragment:Ly,colorspace_pars_fragment:Dy,envmap_fragment:Ny,envmap_common_pars_fragment:Uy,envmap_pars_fragment:Fy,envmap_pars_vertex:Oy,envmap_physical_pars_fragment:Yy,envmap_vertex:By,fog_vertex:ky,fog_pars_vertex:zy,fog_fragment:Vy,fog_pars_fragment:Gy,gradientmap_pars_fragment:Hy,lightmap_pars_fragment:Wy,lights_lambert_fragment:$y,lights_lambert_pars_fragment:Xy,lights_pars_begin:qy,lights_toon_fragment:Zy,lights_toon_pars_fragment:jy,lights_phong_fragment:Jy,lights_phong_pars_fragment:Ky,lights_physical_fragment:Qy,lights_physical_pars_fragment:ev,lights_fragment_begin:tv,lights_fragment_maps:nv,lights_fragment_end:iv,lightprobes_pars_fragment:sv,logdepthbuf_fragment:rv,logdepthbuf_pars_fragment:ov,logdepthbuf_pars_vertex:av,logdepthbuf_vertex:lv,map_fragment:cv,map_pars_fragment:hv,map_particle_fragment:uv,map_particle_pars_fragment:fv,metalnessmap_fragment:dv,metalnessmap_pars_fragment:pv,morphinstance_vertex:mv,morphcolor_vertex:gv,morphnormal_vertex:_v,morphtarget_pars_vertex:xv,morphtarget_vertex:yv,normal_fragment_begin:vv,normal_fragment_maps:Sv,normal_pars_fragment:bv,normal_pars_vertex:Mv,normal_vertex:wv,normalmap_pars_fragment:Tv,clearcoat_normal_fragment_begin:Ev,clearcoat_normal_fragment_maps:Av,clearcoat_pars_fragment:Cv,iridescence_pars_fragment:Rv,opaque_fragment:Pv,packing:Iv,premultiplied_alpha_fragment:Lv,project_vertex:Dv,dithering_fragment:Nv,dithering_pars_fragment:Uv,roughnessmap_fragment:Fv,roughnessmap_pars_fragment:Ov,shadowmap_pars_fragment:Bv,shadowmap_pars_vertex:kv,shadowmap_vertex:zv,shadowmask_pars_fragment:Vv,skinbase_vertex:Gv,skinning_pars_vertex:Hv,skinning_vertex:Wv,skinnormal_vertex:$v,specularmap_fragment:Xv,specularmap_pars_fragment:qv,tonemapping_fragment:Yv,tonemapping_pars_fragment:Zv,transmission_fragment:jv,transmission_pars_fragment:Jv,uv_pars_fragment:Kv,uv_pars_vertex:Qv,uv_vertex:eS,worldpos_vertex:tS,background_vert:nS,background_frag:iS,backgroundCube_vert:sS,backgroundCube_frag:rS,cube_vert:oS,cube_frag:aS,depth_vert:lS,depth_frag:cS,distance_vert:hS,distance_frag:uS,equirect_vert:fS,equirect_frag:dS,linedashed_vert:pS,linedashed_frag:mS,meshbasic_vert:gS,meshbasic_frag:_S,meshlambert_vert:xS,meshlambert_frag:yS,meshmatcap_vert:vS,meshmatcap_frag:SS,meshnormal_vert:bS,meshnormal_frag:MS,meshphong_vert:wS,meshphong_frag:TS,meshphysical_vert:ES,meshphysical_frag:AS,meshtoon_vert:CS,meshtoon_frag:RS,points_vert:PS,points_frag:IS,shadow_vert:LS,shadow_frag:DS,sprite_vert:NS,sprite_frag:US},Ne={common:{diffuse:{value:new ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new ut(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},rs={basic:{uniforms:Gn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:mt.meshbasic_vert,fragmentShader:mt.meshbasic_frag},lambert:{uniforms:Gn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ut(0)},envMapIntensity:{value:1}}]),vertexShader:mt.meshlambert_vert,fragmentShader:mt.meshlambert_frag},phong:{uniforms:Gn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ut(0)},specular:{value:new ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:mt.meshphong_vert,fragmentShader:mt.meshphong_frag},standard:{uniforms:Gn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag},toon:{uniforms:Gn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new ut(0)}}]),vertexShader:mt.meshtoon_vert,fragmentShader:mt.meshtoon_frag},matcap:{uniforms:Gn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:mt.meshmatcap_vert,fragmentShader:mt.meshmatcap_frag},points:{uniforms:Gn([Ne.points,Ne.fog]),vertexShader:mt.points_vert,fragmentShader:mt.points_frag},dashed:{uniforms:Gn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:mt.linedashed_vert,fragmentShader:mt.linedashed_frag},depth:{uniforms:Gn([Ne.common,Ne.displacementmap]),vertexShader:mt.depth_vert,fragmentShader:mt.depth_frag},normal:{uniforms:Gn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:mt.meshnormal_vert,fragmentShader:mt.meshnormal_frag},sprite:{uniforms:Gn([Ne.sprite,Ne.fog]),vertexShader:mt.sprite_vert,fragmentShader:mt.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:mt.background_vert,fragmentShader:mt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:mt.backgroundCube_vert,fragmentShader:mt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:mt.cube_vert,fragmentShader:mt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:mt.equirect_vert,fragmentShader:mt.equirect_frag},distance:{uniforms:Gn([Ne.common,Ne.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:mt.distance_vert,fragmentShader:mt.distance_frag},shadow:{uniforms:Gn([Ne.lights,Ne.fog,{color:{value:new ut(0)},opacity:{value:1}}]),vertexShader:mt.shadow_vert,fragmentShader:mt.shadow_frag}};rs.physical={uniforms:Gn([rs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new ut(0)},specularColor:{value:new ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag};var eh={r:0,b:0,g:0},FS=new zt,Dm=new ot;Dm.set(-1,0,0,0,1,0,0,0,1);function OS(n,e,t,i,s,r){let o=new ut(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let b=v.backgroundBlurriness>0;A=e.get(A,b)}return A}function p(v){let A=!1,b=d(v);b===null?g(o,a):b&&b.isColor&&(g(b,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,A){let b=d(A);b&&b.isCubeTexture?(c===void 0&&(c=new bi(new Zs(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:br(rs.backgroundCube.uniforms),vertexShader:rs.backgroundCube.vertexShader,fragmentShader:rs.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(FS.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Dm),c.material.toneMapped=bt.getTransfer(b.colorSpace)!==Pt,(u!==b||f!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,f=b.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new bi(new ma(2,2),new ts({name:"BackgroundMaterial",uniforms:br(rs.background.uniforms),vertexShader:rs.background.vertexShader,fragmentShader:rs.background.fragmentShader,side:tr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=bt.getTransfer(b.colorSpace)!==Pt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||f!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,f=b.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,A){v.getRGB(eh,ef(n)),t.buffers.color.setClear(eh.r,eh.g,eh.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:p,addToRenderList:y,dispose:m}}function BS(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,D,G,P,W){let O=!1,N=f(L,P,G,D);r!==N&&(r=N,c(r.object)),O=d(L,P,G,W),O&&p(L,P,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(O||o)&&(o=!1,b(L,D,G,P),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,D,G,P){let W=P.wireframe===!0,O=i[D.id];O===void 0&&(O={},i[D.id]=O);let N=L.isInstancedMesh===!0?L.id:0,j=O[N];j===void 0&&(j={},O[N]=j);let $=j[G.id];$===void 0&&($={},j[G.id]=$);let Z=$[W];return Z===void 0&&(Z=h(l()),$[W]=Z),Z}function h(L){let D=[],G=[],P=[];for(let W=0;W<t;W++)D[W]=0,G[W]=0,P[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:G,attributeDivisors:P,object:L,attributes:{},index:null}}function d(L,D,G,P){let W=r.attributes,O=D.attributes,N=0,j=G.getAttributes();for(let $ in j)if(j[$].location>=0){let ne=W[$],fe=O[$];if(fe===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),ne===void 0||ne.attribute!==fe||fe&&ne.data!==fe.data)return!0;N++}return r.attributesNum!==N||r.index!==P}function p(L,D,G,P){let W={},O=D.attributes,N=0,j=G.getAttributes();for(let $ in j)if(j[$].location>=0){let ne=O[$];ne===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(ne=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(ne=L.instanceColor));let fe={};fe.attribute=ne,ne&&ne.data&&(fe.data=ne.data),W[$]=fe,N++}r.attributes=W,r.attributesNum=N,r.index=P}function y(){let L=r.newAttributes;for(let D=0,G=L.length;D<G;D++)L[D]=0}function g(L){m(L,0)}function m(L,D){let G=r.newAttributes,P=r.enabledAttributes,W=r.attributeDivisors;G[L]=1,P[L]===0&&(n.enableVertexAttribArray(L),P[L]=1),W[L]!==D&&(n.vertexAttribDivisor(L,D),W[L]=D)}function v(){let L=r.newAttributes,D=r.enabledAttributes;for(let G=0,P=D.length;G<P;G++)D[G]!==L[G]&&(n.disableVertexAttribArray(G),D[G]=0)}function A(L,D,G,P,W,O,N){N===!0?n.vertexAttribIPointer(L,D,G,W,O):n.vertexAttribPointer(L,D,G,P,W,O)}function b(L,D,G,P){y();let W=P.attributes,O=G.getAttributes(),N=D.defaultAttributeValues;for(let j in O){let $=O[j];if($.location>=0){let Z=W[j];if(Z===void 0&&(j==="instanceMatrix"&&L.instanceMatrix&&(Z=L.instanceMatrix),j==="instanceColor"&&L.instanceColor&&(Z=L.instanceColor)),Z!==void 0){let ne=Z.normalized,fe=Z.itemSize,ue=e.get(Z);if(ue===void 0)continue;let te=ue.buffer,ge=ue.type,ye=ue.bytesPerElement,Ce=ge===n.INT||ge===n.UNSIGNED_INT||Z.gpuType===_c;if(Z.isInterleavedBufferAttribute){let Me=Z.data,$e=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,ct=Z.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let He=0;He<$.locationSize;He++)m($.location+He,Me.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let He=0;He<$.locationSize;He++)g($.location+He);n.bindBuffer(n.ARRAY_BUFFER,te);for(let He=0;He<$.locationSize;He++)A($.location+He,fe/$.locationSize,ge,ne,$e*ye,(ct+fe/$.locationSize*He)*ye,Ce)}else{if(Z.isInstancedBufferAttribute){for(let Me=0;Me<$.locationSize;Me++)m($.location+Me,Z.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let Me=0;Me<$.locationSize;Me++)g($.location+Me);n.bindBuffer(n.ARRAY_BUFFER,te);for(let Me=0;Me<$.locationSize;Me++)A($.location+Me,fe/$.locationSize,ge,ne,fe*ye,fe/$.locationSize*Me*ye,Ce)}}else if(N!==void 0){let ne=N[j];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv($.location,ne);break;case 3:n.vertexAttrib3fv($.location,ne);break;case 4:n.vertexAttrib4fv($.location,ne);break;default:n.vertexAttrib1fv($.location,ne)}}}}v()}function R(){V();for(let L in i){let D=i[L];for(let G in D){let P=D[G];for(let W in P){let O=P[W];for(let N in O)u(O[N].object),delete O[N];delete P[W]}}delete i[L]}}function E(L){if(i[L.id]===void 0)return;let D=i[L.id];for(let G in D){let P=D[G];for(let W in P){let O=P[W];for(let N in O)u(O[N].object),delete O[N];delete P[W]}}delete i[L.id]}function _(L){for(let D in i){let G=i[D];for(let P in G){let W=G[P];if(W[L.id]===void 0)continue;let O=W[L.id];for(let N in O)u(O[N].object),delete O[N];delete W[L.id]}}}function T(L){for(let D in i){let G=i[D],P=L.isInstancedMesh===!0?L.id:0,W=G[P];if(W!==void 0){for(let O in W){let N=W[O];for(let j in N)u(N[j].object),delete N[j];delete W[O]}delete G[P],Object.keys(G).length===0&&delete i[D]}}}function V(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:V,resetDefaultState:F,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:g,disableUnusedAttributes:v}}function kS(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function zS(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Bi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===Oi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==ni&&_!==Fi&&!T&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:b,maxSamples:R,samples:E}}function VS(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ui,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,y=f.clipIntersection,g=f.clipShadows,m=n.get(f);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let v=r?0:i,A=v*4,b=m.clippingState||null;l.value=b,b=u(p,h,A,d);for(let R=0;R!==A;++R)b[R]=t[R];m.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let y=f!==null?f.length:0,g=null;if(y!==0){if(g=l.value,p!==!0||g===null){let m=d+y*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,b=d;A!==y;++A,b+=4)o.copy(f[A]).applyMatrix4(v,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,g}}var Fa=class extends fi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new ua(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Zs(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:br(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qn,blending:xr});r.uniforms.tEquirect.value=t;let o=new bi(s,r),a=t.minFilter;return t.minFilter===As&&(t.minFilter=Jn),new _o(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},um=256,GS=3,HS=20,Nm=256,Um=16,WS=3,$S=new Y,XS=new ut,nh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new _o(1,10,null),this._boxMesh=new bi(new Zs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=$S}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(XS));let g=new _o(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=dm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(um,Ju(e))}_fromTexture(e,t){e.mapping===vr||e.mapping===So?this._setSize(e.image.length===0?um:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=fm(e,!1,!1),i=Math.log2(e)-GS;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=fm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===vr||e.mapping===So?(this._cubemapMaterial===null&&(this._cubemapMaterial=pm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=dm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=qS(),this._integrationMaterial=YS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Um);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-WS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Nm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ZS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function fm(n,e,t){return new Fa(n,{minFilter:As,generateMipmaps:e,type:Oi,colorSpace:sa,depthBuffer:t})}function Oa(n,e,t){return new ts({name:n,uniforms:e,vertexShader:mt.cube_vert,fragmentShader:t,side:Qn,blending:xr,depthTest:!1,depthWrite:!1})}function qS(){return Oa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Nm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function YS(){return Oa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Um}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ZS(){return Oa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${HS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function dm(){return Oa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function pm(){return Oa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function jS(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===pc||d===mc)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let y=new Fa(p.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===pc||d===mc,y=d===vr||d===So;if(p||y){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new nh(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let v=h.image;return p&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new nh(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===pc?h.mapping=vr:d===mc&&(h.mapping=So),h}function l(h){let d=0,p=6;for(let y=0;y<p;y++)h[y]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function JS(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ea("WebGLRenderer: "+i+" extension not supported."),s}}}function KS(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(e.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(p){let y=p.attributes;for(let g in y)e.update(y[g],n.ARRAY_BUFFER)}function f(p){let y=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let v=y!==null?y.array.length:g.array.length/3-1,A=g.count>=65535?ha:ca,b=new A(Math.ceil(v/3)*6,1),R=b.array;if(y!==null){let _=y.array;m=y.version;for(let T=0,V=0;T<v;T+=3){let F=_[T+0],L=_[T+1],D=_[T+2];R[V++]=F,R[V++]=L,R[V++]=L,R[V++]=D,R[V++]=D,R[V++]=F}}else{m=g.version;for(let _=0,T=0;_<v;_+=3){let V=_+0,F=_+1,L=_+2;R[T++]=V,R[T++]=F,R[T++]=F,R[T++]=L,R[T++]=L,R[T++]=V}}b.version=m;let E=r.get(p);E&&e.remove(E),r.set(p,b)}function h(p){let y=r.get(p);if(y){let g=p.index;g!==null&&y.version<g.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function QS(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let y=0;for(let g=0;g<d;g++)y+=h[g];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function eb(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function tb(n,e,t){let i=new WeakMap,s=new Qt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let V=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",V)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;d===!0&&(A=1),p===!0&&(A=2),y===!0&&(A=3);let b=a.attributes.position.count*A,R=1;b>e.maxTextureSize&&(R=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let E=new Float32Array(b*R*4*f),_=new aa(E,b,R,f);_.type=Fi,_.needsUpdate=!0;let T=A*4;for(let F=0;F<f;F++){let L=g[F],D=m[F],G=v[F],P=b*R*4*F;for(let W=0;W<L.count;W++){let O=W*T;d===!0&&(s.fromBufferAttribute(L,W),E[P+O+0]=s.x,E[P+O+1]=s.y,E[P+O+2]=s.z,E[P+O+3]=0),p===!0&&(s.fromBufferAttribute(D,W),E[P+O+4]=s.x,E[P+O+5]=s.y,E[P+O+6]=s.z,E[P+O+7]=0),y===!0&&(s.fromBufferAttribute(G,W),E[P+O+8]=s.x,E[P+O+9]=s.y,E[P+O+10]=s.z,E[P+O+11]=G.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new Ke(b,R)},i.set(a,h),a.addEventListener("dispose",V)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function nb(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var ib={[Pu]:"LINEAR_TONE_MAPPING",[Iu]:"REINHARD_TONE_MAPPING",[Lu]:"CINEON_TONE_MAPPING",[Du]:"ACES_FILMIC_TONE_MAPPING",[Uu]:"AGX_TONE_MAPPING",[Fu]:"NEUTRAL_TONE_MAPPING",[Nu]:"CUSTOM_TONE_MAPPING"};function sb(n,e,t,i,s,r){let o=new fi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new vn;u.setAttribute("position",new Bt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Bt([0,2,0,0,2,0],2));let f=new Jl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new bi(u,f),d=new Sa(-1,1,1,-1,0,1),p=null,y=null,g=!1,m,v=null,A=[],b=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let _=0;_<A.length;_++){let T=A[_];T.setSize&&T.setSize(R,E)}},this.setEffects=function(R){A=R,b=A.length>0&&A[0].isRenderPass===!0;let E=o.width,_=o.height;A.length>0&&a===null&&(a=new fi(E,_,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new fi(E,_,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(V=>V.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Es(E,_),r===!0&&(c.format=Cs,c.type=Sr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let V=0;V<A.length;V++){let F=A[V];F.setSize&&F.setSize(E,_),T&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(R,E){if(g||R.toneMapping===is&&A.length===0)return!1;if(v=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return b===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=is,!0},this.hasRenderPass=function(){return b},this.end=function(R,E){R.toneMapping=m,g=!0;let _=o,T=a;for(let V=0;V<A.length;V++){let F=A[V];F.enabled!==!1&&(F.render(R,T,_,E),F.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(p!==R.outputColorSpace||y!==R.toneMapping){p=R.outputColorSpace,y=R.toneMapping,f.defines={},bt.getTransfer(p)===Pt&&(f.defines.SRGB_TRANSFER="");let V=ib[y];V&&(f.defines[V]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(v),R.render(h,d),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Fm=new Kn,Om=new Es(1,1),Bm=new da(1),km=new aa,zm=new $l,Vm=new ua,mm=[],gm=[],_m=new Float32Array(16),xm=new Float32Array(9),ym=new Float32Array(4);function To(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=mm[s];if(r===void 0&&(r=new Float32Array(s),mm[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Sn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function bn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function sh(n,e){let t=gm[e];t===void 0&&(t=new Int32Array(e),gm[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function rb(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function ob(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2fv(this.addr,e),bn(t,e)}}function ab(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;n.uniform3fv(this.addr,e),bn(t,e)}}function lb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4fv(this.addr,e),bn(t,e)}}function cb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),bn(t,e)}else{if(Sn(t,i))return;ym.set(i),n.uniformMatrix2fv(this.addr,!1,ym),bn(t,i)}}function hb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),bn(t,e)}else{if(Sn(t,i))return;xm.set(i),n.uniformMatrix3fv(this.addr,!1,xm),bn(t,i)}}function ub(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),bn(t,e)}else{if(Sn(t,i))return;_m.set(i),n.uniformMatrix4fv(this.addr,!1,_m),bn(t,i)}}function fb(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function db(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2iv(this.addr,e),bn(t,e)}}function pb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3iv(this.addr,e),bn(t,e)}}function mb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4iv(this.addr,e),bn(t,e)}}function gb(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function _b(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2uiv(this.addr,e),bn(t,e)}}function xb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3uiv(this.addr,e),bn(t,e)}}function yb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4uiv(this.addr,e),bn(t,e)}}function rh(n){return n.version===0&&(n.compareFunction=qu,n.needsUpdate=!0),n}function vb(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=rh(Om):r=Fm,t.setTexture2D(e||r,s)}function Sb(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||zm,s)}function bb(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=rh(Bm):r=Vm,t.setTextureCube(e||r,s)}function Mb(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||km,s)}function wb(n){switch(n){case 5126:return rb;case 35664:return ob;case 35665:return ab;case 35666:return lb;case 35674:return cb;case 35675:return hb;case 35676:return ub;case 5124:case 35670:return fb;case 35667:case 35671:return db;case 35668:case 35672:return pb;case 35669:case 35673:return mb;case 5125:return gb;case 36294:return _b;case 36295:return xb;case 36296:return yb;case 35678:case 36198:case 36298:case 36306:case 35682:return vb;case 35679:case 36299:case 36307:return Sb;case 35680:case 36300:case 36308:case 36293:return bb;case 36289:case 36303:case 36311:case 36292:return Mb}}function Tb(n,e){n.uniform1fv(this.addr,e)}function Eb(n,e){let t=To(e,this.size,2);n.uniform2fv(this.addr,t)}function Ab(n,e){let t=To(e,this.size,3);n.uniform3fv(this.addr,t)}function Cb(n,e){let t=To(e,this.size,4);n.uniform4fv(this.addr,t)}function Rb(n,e){let t=To(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Pb(n,e){let t=To(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Ib(n,e){let t=To(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Lb(n,e){n.uniform1iv(this.addr,e)}function Db(n,e){n.uniform2iv(this.addr,e)}function Nb(n,e){n.uniform3iv(this.addr,e)}function Ub(n,e){n.uniform4iv(this.addr,e)}function Fb(n,e){n.uniform1uiv(this.addr,e)}function Ob(n,e){n.uniform2uiv(this.addr,e)}function Bb(n,e){n.uniform3uiv(this.addr,e)}function kb(n,e){n.uniform4uiv(this.addr,e)}function zb(n,e,t){let i=this.cache,s=e.length,r=sh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=rh(Om):o=Fm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Vb(n,e,t){let i=this.cache,s=e.length,r=sh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||zm,r[o])}function Gb(n,e,t){let i=this.cache,s=e.length,r=sh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=rh(Bm):o=Vm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Hb(n,e,t){let i=this.cache,s=e.length,r=sh(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||km,r[o])}function Wb(n){switch(n){case 5126:return Tb;case 35664:return Eb;case 35665:return Ab;case 35666:return Cb;case 35674:return Rb;case 35675:return Pb;case 35676:return Ib;case 5124:case 35670:return Lb;case 35667:case 35671:return Db;case 35668:case 35672:return Nb;case 35669:case 35673:return Ub;case 5125:return Fb;case 36294:return Ob;case 36295:return Bb;case 36296:return kb;case 35678:case 36198:case 36298:case 36306:case 35682:return zb;case 35679:case 36299:case 36307:return Vb;case 35680:case 36300:case 36308:case 36293:return Gb;case 36289:case 36303:case 36311:case 36292:return Hb}}var ff=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=wb(t.type)}},df=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Wb(t.type)}},pf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},hf=/(\w+)(\])?(\[|\.)?/g;function vm(n,e){n.seq.push(e),n.map[e.id]=e}function $b(n,e,t){let i=n.name,s=i.length;for(hf.lastIndex=0;;){let r=hf.exec(i),o=hf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){vm(t,c===void 0?new ff(a,n,e):new df(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new pf(a),vm(t,f)),t=f}}}var wo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);$b(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Sm(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Xb=37297,qb=0;function Yb(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var bm=new ot;function Zb(n){bt._getMatrix(bm,bt.workingColorSpace,n);let e=`mat3( ${bm.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(n)){case ra:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Mm(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Yb(n.getShaderSource(e),a)}else return r}function jb(n,e){let t=Zb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Jb={[Pu]:"Linear",[Iu]:"Reinhard",[Lu]:"Cineon",[Du]:"ACESFilmic",[Uu]:"AgX",[Fu]:"Neutral",[Nu]:"Custom"};function Kb(n,e){let t=Jb[e];return t===void 0?(je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var th=new Y;function Qb(){bt.getLuminanceCoefficients(th);let n=th.x.toFixed(4),e=th.y.toFixed(4),t=th.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function eM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ua).join(`
`)}function tM(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function nM(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ua(n){return n!==""}function wm(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Tm(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var iM=/^[ \t]*#include +<([\w\d./]+)>/gm;function mf(n){return n.replace(iM,sM)}function sM(n,e){let t=mt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return mf(t)}var rM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Em(n){return n.replace(rM,oM)}function oM(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Am(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var aM={[Ea]:"SHADOWMAP_TYPE_PCF",[yo]:"SHADOWMAP_TYPE_VSM"};function lM(n){return aM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var cM={[So]:"ENVMAP_MODE_REFRACTION"};function hM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":cM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var uM={[dc]:"ENVMAP_BLENDING_MULTIPLY",[Hp]:"ENVMAP_BLENDING_MIX",[Wp]:"ENVMAP_BLENDING_ADD"};function fM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":uM[n.combine]||"ENVMAP_BLENDING_NONE"}function dM(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=lM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=hM(t),f=fM(t),h=eM(t),d=tM(r),p=s.createProgram(),y,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ua).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ua).join(`
`),g.length>0&&(g+=`
`)):(y=[Am(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ua).join(`
`),g=[Am(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==is?"#define TONE_MAPPING":"",t.toneMapping!==is?mt.tonemapping_pars_fragment:"",t.toneMapping!==is?Kb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",mt.colorspace_pars_fragment,jb("linearToOutputTexel",t.outputColorSpace),Qb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ua).join(`
`)),o=mf(o),o=wm(o,t),o=Tm(o,t),a=mf(a),a=wm(a,t),a=Tm(a,t),o=Em(o),a=Em(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",t.glslVersion===Yu?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Yu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=m+y+o,A=m+g+a,b=Sm(s,s.VERTEX_SHADER,v),R=Sm(s,s.FRAGMENT_SHADER,A);s.attachShader(p,b),s.attachShader(p,R),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(F){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(b)||"",G=s.getShaderInfoLog(R)||"",P=L.trim(),W=D.trim(),O=G.trim(),N=!0,j=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(N=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,R);else{let $=Mm(s,b,"vertex"),Z=Mm(s,R,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+P+`
`+$+`
`+Z)}else P!==""?je("WebGLProgram: Program Info Log:",P):(W===""||O==="")&&(j=!1);j&&(F.diagnostics={runnable:N,programLog:P,vertexShader:{log:W,prefix:y},fragmentShader:{log:O,prefix:g}})}s.deleteShader(b),s.deleteShader(R),_=new wo(s,p),T=nM(s,p)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let V=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return V===!1&&(V=s.getProgramParameter(p,Xb)),V},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=qb++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=R,this}var pM=0,gf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new _f(e),t.set(e,i)),i}},_f=class{constructor(e){this.id=pM++,this.code=e,this.usedTimes=0}};function mM(n){return n===nr||n===La||n===Da}function gM(n,e,t,i,s,r){let o=new ho,a=new gf,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,T,V,F,L,D){let G=F.fog,P=L.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?F.environment:null,O=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,N=e.get(_.envMap||W,O),j=h[_.type],$=i.precision;_.precision!==null&&($=i.getMaxPrecision(_.precision),$!==_.precision&&je("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let Z=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,ne=Z!==void 0?Z.length:0,fe=0;P.morphAttributes.position!==void 0&&(fe=1),P.morphAttributes.normal!==void 0&&(fe=2),P.morphAttributes.color!==void 0&&(fe=3);let ue,te,ge,ye;if(j){let Re=rs[j];ue=Re.vertexShader,te=Re.fragmentShader}else{ue=_.vertexShader,te=_.fragmentShader;let Re=a.getVertexShaderStage(_),ft=a.getFragmentShaderStage(_);a.update(_,Re,ft),ge=Re.id,ye=ft.id}let Ce=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),$e=L.isInstancedMesh===!0,ct=L.isBatchedMesh===!0,He=!!_.map,gt=!!_.matcap,dt=!!N,at=dt&&N.isPMREMTexture===!0,Jt=!!_.aoMap,Wt=!!_.lightMap,hn=!!_.bumpMap&&_.wireframe===!1,Ut=!!_.normalMap,En=!!_.displacementMap,wt=!!_.emissiveMap,xn=!!_.metalnessMap,nn=!!_.roughnessMap,un=_.anisotropy>0,z=_.clearcoat>0,Pe=_.diffuseRoughness>0,Je=_.dispersion>0,ht=_.retroreflectivity>0,we=_.iridescence>0,kt=_.sheen>0,Ge=_.transmission>0,Ye=un&&!!_.anisotropyMap,C=z&&!!_.clearcoatMap,S=z&&!!_.clearcoatNormalMap,q=z&&!!_.clearcoatRoughnessMap,he=Pe&&!!_.diffuseRoughnessMap,ae=we&&!!_.iridescenceMap,xe=we&&!!_.iridescenceThicknessMap,ve=kt&&!!_.sheenColorMap,ie=kt&&!!_.sheenRoughnessMap,re=!!_.specularMap,me=!!_.specularColorMap,k=!!_.specularIntensityMap,oe=Ge&&!!_.transmissionMap,se=Ge&&!!_.thicknessMap,Te=!!_.gradientMap,_e=!!_.alphaMap,be=_.alphaTest>0,We=!!_.alphaHash,tt=!!_.extensions,ce=is;_.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=at?N.isCompressedCubeTexture?N.image[0].mipmaps:N.mipmaps:null,nt={shaderID:j,shaderType:_.type,shaderName:_.name,vertexShader:ue,fragmentShader:te,defines:_.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:ct,batchingColor:ct&&L._colorsTexture!==null,instancing:$e,instancingColor:$e&&L.instanceColor!==null,instancingMorph:$e&&L.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:He,matcap:gt,envMap:dt,envMapMode:dt&&N.mapping,envMapPMREM:at,envMapMaxLod:at?ke.length-1:null,envMapSize:at?ke[0].width:null,aoMap:Jt,lightMap:Wt,bumpMap:hn,normalMap:Ut,displacementMap:En,emissiveMap:wt,normalMapObjectSpace:Ut&&_.normalMapType===qp,normalMapTangentSpace:Ut&&_.normalMapType===Qc,packedNormalMap:Ut&&_.normalMapType===Qc&&mM(_.normalMap.format),metalnessMap:xn,roughnessMap:nn,anisotropy:un,anisotropyMap:Ye,clearcoat:z,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:he,dispersion:Je,retroreflection:ht,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:xe,sheen:kt,sheenColorMap:ve,sheenRoughnessMap:ie,specularMap:re,specularColorMap:me,specularIntensityMap:k,transmission:Ge,transmissionMap:oe,thicknessMap:se,gradientMap:Te,opaque:_.transparent===!1&&_.blending===vo&&_.alphaToCoverage===!1,alphaMap:_e,alphaTest:be,alphaHash:We,combine:_.combine,mapUv:He&&d(_.map.channel),aoMapUv:Jt&&d(_.aoMap.channel),lightMapUv:Wt&&d(_.lightMap.channel),bumpMapUv:hn&&d(_.bumpMap.channel),normalMapUv:Ut&&d(_.normalMap.channel),displacementMapUv:En&&d(_.displacementMap.channel),emissiveMapUv:wt&&d(_.emissiveMap.channel),metalnessMapUv:xn&&d(_.metalnessMap.channel),roughnessMapUv:nn&&d(_.roughnessMap.channel),anisotropyMapUv:Ye&&d(_.anisotropyMap.channel),clearcoatMapUv:C&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:ie&&d(_.sheenRoughnessMap.channel),specularMapUv:re&&d(_.specularMap.channel),specularColorMapUv:me&&d(_.specularColorMap.channel),specularIntensityMapUv:k&&d(_.specularIntensityMap.channel),transmissionMapUv:oe&&d(_.transmissionMap.channel),thicknessMapUv:se&&d(_.thicknessMap.channel),alphaMapUv:_e&&d(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Ut||un),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(He||_e),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&Ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Me,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:fe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:D.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&V.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:He&&_.map.isVideoTexture===!0&&bt.getTransfer(_.map.colorSpace)===Pt,decodeVideoTextureEmissive:wt&&_.emissiveMap.isVideoTexture===!0&&bt.getTransfer(_.emissiveMap.colorSpace)===Pt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ns,flipSided:_.side===Qn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:tt&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&_.extensions.multiDraw===!0||ct)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function y(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let V in _.defines)T.push(V),T.push(_.defines[V]);return _.isRawShaderMaterial===!1&&(g(T,_),m(T,_),T.push(n.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function g(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function m(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let T=h[_.type],V;if(T){let F=rs[T];V=lm.clone(F.uniforms)}else V=_.uniforms;return V}function A(_,T){let V=u.get(T);return V!==void 0?++V.usedTimes:(V=new dM(n,T,_,s),c.push(V),u.set(T,V)),V}function b(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:v,acquireProgram:A,releaseProgram:b,releaseShaderCache:R,programs:c,dispose:E}}function _M(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function xM(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Cm(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Rm(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,y,g,m){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:g,group:m},n[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=p,v.materialVariant=o(h),v.groupOrder=y,v.renderOrder=h.renderOrder,v.z=g,v.group=m),e++,v}function l(h,d,p,y,g,m,v){v.reversedDepth===!0&&(g=-g);let A=a(h,d,p,y,g,m);p.transmission>0?i.push(A):p.transparent===!0?s.push(A):t.push(A)}function c(h,d,p,y,g,m){let v=a(h,d,p,y,g,m);p.transmission>0?i.unshift(v):p.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||xM),i.length>1&&i.sort(d||Cm),s.length>1&&s.sort(d||Cm)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function yM(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Rm,n.set(i,[o])):s>=r.length?(o=new Rm,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function vM(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Y,color:new ut};break;case"SpotLight":t={position:new Y,direction:new Y,color:new ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new ut,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new ut,groundColor:new ut};break;case"RectAreaLight":t={color:new ut,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return n[e.id]=t,t}}}function SM(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var bM=0;function MM(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function wM(n){let e=new vM,t=SM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Y);let s=new Y,r=new zt,o=new zt;function a(c){let u=0,f=0,h=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let d=0,p=0,y=0,g=0,m=0,v=0,A=0,b=0,R=0,E=0,_=0,T=0,V=0,F=0;c.sort(MM);for(let D=0,G=c.length;D<G;D++){let P=c[D],W=P.color,O=P.intensity,N=P.distance,j=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===nr?j=P.shadow.map.texture:j=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=W.r*O,f+=W.g*O,h+=W.b*O;else if(P.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(P.sh.coefficients[$],O);F++}else if(P.isSunLight){let $=e.get(P);if($.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,ne=t.get(P);ne.shadowIntensity=Z.intensity,ne.shadowBias=Z.bias,ne.shadowNormalBias=Z.normalBias,ne.shadowRadius=Z.radius,ne.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[p]=ne,i.sunShadowMap[p]=j;let fe=Z.getViewportCount();for(let ue=0;ue<fe;ue++)i.sunShadowMatrix[y+ue]=Z.getMatrix(ue),i.sunShadowCascade[y+ue]=Z._cascadeData[ue];y+=fe,p++}i.sun[d]=$,d++}else if(P.isDirectionalLight){let $=e.get(P);if($.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,ne=t.get(P);ne.shadowIntensity=Z.intensity,ne.shadowBias=Z.bias,ne.shadowNormalBias=Z.normalBias,ne.shadowRadius=Z.radius,ne.shadowMapSize=Z.mapSize,i.directionalShadow[g]=ne,i.directionalShadowMap[g]=j,i.directionalShadowMatrix[g]=P.shadow.matrix,R++}i.directional[g]=$,g++}else if(P.isSpotLight){let $=e.get(P);$.position.setFromMatrixPosition(P.matrixWorld),$.color.copy(W).multiplyScalar(O),$.distance=N,$.coneCos=Math.cos(P.angle),$.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),$.decay=P.decay,i.spot[v]=$;let Z=P.shadow;if(P.map&&(i.spotLightMap[T]=P.map,T++,Z.updateMatrices(P),P.castShadow&&V++),i.spotLightMatrix[v]=Z.matrix,P.castShadow){let ne=t.get(P);ne.shadowIntensity=Z.intensity,ne.shadowBias=Z.bias,ne.shadowNormalBias=Z.normalBias,ne.shadowRadius=Z.radius,ne.shadowMapSize=Z.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=j,_++}v++}else if(P.isRectAreaLight){let $=e.get(P);$.color.copy(W).multiplyScalar(O),$.halfWidth.set(P.width*.5,0,0),$.halfHeight.set(0,P.height*.5,0),i.rectArea[A]=$,A++}else if(P.isPointLight){let $=e.get(P);if($.color.copy(P.color).multiplyScalar(P.intensity),$.distance=P.distance,$.decay=P.decay,P.castShadow){let Z=P.shadow,ne=t.get(P);ne.shadowIntensity=Z.intensity,ne.shadowBias=Z.bias,ne.shadowNormalBias=Z.normalBias,ne.shadowRadius=Z.radius,ne.shadowMapSize=Z.mapSize,ne.shadowCameraNear=Z.camera.near,ne.shadowCameraFar=Z.camera.far,i.pointShadow[m]=ne,i.pointShadowMap[m]=j,i.pointShadowMatrix[m]=P.shadow.matrix,E++}i.point[m]=$,m++}else if(P.isHemisphereLight){let $=e.get(P);$.skyColor.copy(P.color).multiplyScalar(O),$.groundColor.copy(P.groundColor).multiplyScalar(O),i.hemi[b]=$,b++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==v||L.rectAreaLength!==A||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==R||L.numPointShadows!==E||L.numSpotShadows!==_||L.numSpotMaps!==T||L.numLightProbes!==F)&&(i.sun.length=d,i.directional.length=g,i.spot.length=v,i.rectArea.length=A,i.point.length=m,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+T-V,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=V,i.numLightProbes=F,L.sunLength=d,L.directionalLength=g,L.pointLength=m,L.spotLength=v,L.rectAreaLength=A,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=R,L.numPointShadows=E,L.numSpotShadows=_,L.numSpotMaps=T,L.numLightProbes=F,i.version=bM++)}function l(c,u){let f=0,h=0,d=0,p=0,y=0,g=0,m=u.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let b=c[v];if(b.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(m),f++}else if(b.isDirectionalLight){let R=i.directional[h];R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),h++}else if(b.isSpotLight){let R=i.spot[p];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let R=i.rectArea[y];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(b.width*.5,0,0),R.halfHeight.set(0,b.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let R=i.point[d];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let R=i.hemi[g];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Pm(n){let e=new wM(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function TM(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Pm(n),e.set(s,[a])):r>=o.length?(a=new Pm(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var EM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,AM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,CM=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],RM=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],Im=new zt,Na=new Y,uf=new Y;function PM(n,e,t){let i=new qs,s=new Ke,r=new Ke,o=new Qt,a=new Kl,l=new Ql,c={},u=t.maxTextureSize,f={[tr]:Qn,[Qn]:tr,[ns]:ns},h=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:EM,fragmentShader:AM}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new vn;p.setAttribute("position",new Ki(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new bi(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ea;let m=this.type;this.render=function(E,_,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===wp&&(je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ea);let V=n.getRenderTarget(),F=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),D=n.state;D.setBlending(xr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let G=m!==this.type;G&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(W=>W.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,W=E.length;P<W;P++){let O=E[P],N=O.shadow;if(N===void 0){je("WebGLShadowMap:",O,"has no shadow.");continue}if(N.autoUpdate===!1&&N.needsUpdate===!1)continue;s.copy(N.mapSize);let j=N.getFrameExtents();s.multiply(j),r.copy(N.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/j.x),s.x=r.x*j.x,N.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/j.y),s.y=r.y*j.y,N.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(N.camera._reversedDepth=$,N.map===null||G===!0){if(N.map!==null&&(N.map.depthTexture!==null&&(N.map.depthTexture.dispose(),N.map.depthTexture=null),N.map.dispose()),this.type===yo){if(O.isPointLight){je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}N.map=new fi(s.x,s.y,{format:nr,type:Oi,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),N.map.texture.name=O.name+".shadowMap",N.map.depthTexture=new Es(s.x,s.y,Fi),N.map.depthTexture.name=O.name+".shadowMapDepth",N.map.depthTexture.format=Ms,N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=Ln,N.map.depthTexture.magFilter=Ln}else O.isPointLight?(N.map=new Fa(s.x),N.map.depthTexture=new da(s.x,Ui)):(N.map=new fi(s.x,s.y),N.map.depthTexture=new Es(s.x,s.y,Ui)),N.map.depthTexture.name=O.name+".shadowMap",N.map.depthTexture.format=Ms,this.type===Ea?(N.map.depthTexture.compareFunction=$?Xu:$u,N.map.depthTexture.minFilter=Jn,N.map.depthTexture.magFilter=Jn):(N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=Ln,N.map.depthTexture.magFilter=Ln);N.camera.updateProjectionMatrix()}N.map.isWebGLCubeRenderTarget!==!0&&(N.map.width!==s.x||N.map.height!==s.y)&&N.map.setSize(s.x,s.y);let Z=N.map.isWebGLCubeRenderTarget?6:N.getViewportCount();O.isPointLight!==!0&&N.updateMatrices(O,T);let ne=(N.camera.layers.mask&4294967294)!==0?N.camera.layers:T.layers;for(let fe=0;fe<Z;fe++){let ue=N.getCamera(fe);if(O.isPointLight){let te=N.camera,ge=N.matrix,ye=O.distance||te.far;ye!==te.far&&(te.far=ye,te.updateProjectionMatrix()),Na.setFromMatrixPosition(O.matrixWorld),te.position.copy(Na),uf.copy(te.position),uf.add(CM[fe]),te.up.copy(RM[fe]),te.lookAt(uf),te.updateMatrixWorld(),ge.makeTranslation(-Na.x,-Na.y,-Na.z),Im.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),N._frustum.setFromProjectionMatrix(Im,te.coordinateSystem,te.reversedDepth)}if(N.map.isWebGLCubeRenderTarget)n.setRenderTarget(N.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(N.map),n.clear());let te=N.getViewport(fe);o.set(r.x*te.x,r.y*te.y,r.x*te.z,r.y*te.w),D.viewport(o)}i=N.getFrustum(fe),b(_,T,ue,O,ne,this.type)}N.isPointLightShadow!==!0&&this.type===yo&&v(N,T),N.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(V,F,L)};function v(E,_){let T=e.update(y);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new fi(s.x,s.y,{format:nr,type:Oi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,T,h,y,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,T,d,y,null)}function A(E,_,T,V){let F=null,L=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)F=L;else if(F=T.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let D=F.uuid,G=_.uuid,P=c[D];P===void 0&&(P={},c[D]=P);let W=P[G];W===void 0&&(W=F.clone(),P[G]=W,_.addEventListener("dispose",R)),F=W}if(F.visible=_.visible,F.wireframe=_.wireframe,V===yo?F.side=_.shadowSide!==null?_.shadowSide:_.side:F.side=_.shadowSide!==null?_.shadowSide:f[_.side],F.alphaMap=_.alphaMap,F.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,F.map=_.map,F.clipShadows=_.clipShadows,F.clippingPlanes=_.clippingPlanes,F.clipIntersection=_.clipIntersection,F.displacementMap=_.displacementMap,F.displacementScale=_.displacementScale,F.displacementBias=_.displacementBias,F.wireframeLinewidth=_.wireframeLinewidth,F.linewidth=_.linewidth,T.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let D=n.properties.get(F);D.light=T}return F}function b(E,_,T,V,F,L){if(E.visible===!1)return;if(E.layers.test(F)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===yo)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let P=e.update(E),W=E.material;if(Array.isArray(W)){let O=P.groups;for(let N=0,j=O.length;N<j;N++){let $=O[N],Z=W[$.materialIndex];if(Z&&Z.visible){let ne=A(E,Z,V,L);E.onBeforeShadow(n,E,_,T,P,ne,$),n.renderBufferDirect(T,null,P,ne,E,$),E.onAfterShadow(n,E,_,T,P,ne,$)}}}else if(W.visible){let O=A(E,W,V,L);E.onBeforeShadow(n,E,_,T,P,O,null),n.renderBufferDirect(T,null,P,O,E,null),E.onAfterShadow(n,E,_,T,P,O,null)}}let G=E.children;for(let P=0,W=G.length;P<W;P++)b(G[P],_,T,V,F,L)}function R(E){E.target.removeEventListener("dispose",R);for(let T in c){let V=c[T],F=E.target.uuid;F in V&&(V[F].dispose(),delete V[F])}}}function IM(n,e){function t(){let k=!1,oe=new Qt,se=null,Te=new Qt(0,0,0,0);return{setMask:function(_e){se!==_e&&!k&&(n.colorMask(_e,_e,_e,_e),se=_e)},setLocked:function(_e){k=_e},setClear:function(_e,be,We,tt,ce){ce===!0&&(_e*=tt,be*=tt,We*=tt),oe.set(_e,be,We,tt),Te.equals(oe)===!1&&(n.clearColor(_e,be,We,tt),Te.copy(oe))},reset:function(){k=!1,se=null,Te.set(-1,0,0,0)}}}function i(){let k=!1,oe=!1,se=null,Te=null,_e=null;return{setReversed:function(be){if(oe!==be){let We=e.get("EXT_clip_control");be?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),oe=be;let tt=_e;_e=null,this.setClear(tt)}},getReversed:function(){return oe},setTest:function(be){be?Me(n.DEPTH_TEST):$e(n.DEPTH_TEST)},setMask:function(be){se!==be&&!k&&(n.depthMask(be),se=be)},setFunc:function(be){if(oe&&(be=sm[be]),Te!==be){switch(be){case Dl:n.depthFunc(n.NEVER);break;case Nl:n.depthFunc(n.ALWAYS);break;case Ul:n.depthFunc(n.LESS);break;case ro:n.depthFunc(n.LEQUAL);break;case Fl:n.depthFunc(n.EQUAL);break;case Ol:n.depthFunc(n.GEQUAL);break;case Bl:n.depthFunc(n.GREATER);break;case kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=be}},setLocked:function(be){k=be},setClear:function(be){_e!==be&&(_e=be,oe&&(be=1-be),n.clearDepth(be))},reset:function(){k=!1,se=null,Te=null,_e=null,oe=!1}}}function s(){let k=!1,oe=null,se=null,Te=null,_e=null,be=null,We=null,tt=null,ce=null;return{setTest:function(ke){k||(ke?Me(n.STENCIL_TEST):$e(n.STENCIL_TEST))},setMask:function(ke){oe!==ke&&!k&&(n.stencilMask(ke),oe=ke)},setFunc:function(ke,nt,Re){(se!==ke||Te!==nt||_e!==Re)&&(n.stencilFunc(ke,nt,Re),se=ke,Te=nt,_e=Re)},setOp:function(ke,nt,Re){(be!==ke||We!==nt||tt!==Re)&&(n.stencilOp(ke,nt,Re),be=ke,We=nt,tt=Re)},setLocked:function(ke){k=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){k=!1,oe=null,se=null,Te=null,_e=null,be=null,We=null,tt=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],y=null,g=!1,m=null,v=null,A=null,b=null,R=null,E=null,_=null,T=new ut(0,0,0),V=0,F=!1,L=null,D=null,G=null,P=null,W=null,O=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,j=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec($)[1]),N=j>=1):$.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),N=j>=2);let Z=null,ne={},fe=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),te=new Qt().fromArray(fe),ge=new Qt().fromArray(ue);function ye(k,oe,se,Te){let _e=new Uint8Array(4),be=n.createTexture();n.bindTexture(k,be),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<se;We++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(oe+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return be}let Ce={};Ce[n.TEXTURE_2D]=ye(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=ye(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=ye(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=ye(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(ro),hn(!1),Ut(wu),Me(n.CULL_FACE),Jt(xr);function Me(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function $e(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function ct(k,oe){return h[k]!==oe?(n.bindFramebuffer(k,oe),h[k]=oe,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=oe),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function He(k,oe){let se=p,Te=!1;if(k){se=d.get(oe),se===void 0&&(se=[],d.set(oe,se));let _e=k.textures;if(se.length!==_e.length||se[0]!==n.COLOR_ATTACHMENT0){for(let be=0,We=_e.length;be<We;be++)se[be]=n.COLOR_ATTACHMENT0+be;se.length=_e.length,Te=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Te=!0);Te&&n.drawBuffers(se)}function gt(k){return y!==k?(n.useProgram(k),y=k,!0):!1}let dt={[yr]:n.FUNC_ADD,[Ep]:n.FUNC_SUBTRACT,[Ap]:n.FUNC_REVERSE_SUBTRACT};dt[Cp]=n.MIN,dt[Rp]=n.MAX;let at={[Pp]:n.ZERO,[Ip]:n.ONE,[Lp]:n.SRC_COLOR,[Cu]:n.SRC_ALPHA,[Bp]:n.SRC_ALPHA_SATURATE,[Fp]:n.DST_COLOR,[Np]:n.DST_ALPHA,[Dp]:n.ONE_MINUS_SRC_COLOR,[Ru]:n.ONE_MINUS_SRC_ALPHA,[Op]:n.ONE_MINUS_DST_COLOR,[Up]:n.ONE_MINUS_DST_ALPHA,[kp]:n.CONSTANT_COLOR,[zp]:n.ONE_MINUS_CONSTANT_COLOR,[Vp]:n.CONSTANT_ALPHA,[Gp]:n.ONE_MINUS_CONSTANT_ALPHA};function Jt(k,oe,se,Te,_e,be,We,tt,ce,ke){if(k===xr){g===!0&&($e(n.BLEND),g=!1);return}if(g===!1&&(Me(n.BLEND),g=!0),k!==Tp){if(k!==m||ke!==F){if((v!==yr||R!==yr)&&(n.blendEquation(n.FUNC_ADD),v=yr,R=yr),ke)switch(k){case vo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Tu:n.blendFunc(n.ONE,n.ONE);break;case Eu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Au:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",k);break}else switch(k){case vo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Tu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Eu:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Au:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",k);break}A=null,b=null,E=null,_=null,T.set(0,0,0),V=0,m=k,F=ke}return}_e=_e||oe,be=be||se,We=We||Te,(oe!==v||_e!==R)&&(n.blendEquationSeparate(dt[oe],dt[_e]),v=oe,R=_e),(se!==A||Te!==b||be!==E||We!==_)&&(n.blendFuncSeparate(at[se],at[Te],at[be],at[We]),A=se,b=Te,E=be,_=We),(tt.equals(T)===!1||ce!==V)&&(n.blendColor(tt.r,tt.g,tt.b,ce),T.copy(tt),V=ce),m=k,F=!1}function Wt(k,oe){k.side===ns?$e(n.CULL_FACE):Me(n.CULL_FACE);let se=k.side===Qn;oe&&(se=!se),hn(se),k.blending===vo&&k.transparent===!1?Jt(xr):Jt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Te=k.stencilWrite;a.setTest(Te),Te&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),wt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):$e(n.SAMPLE_ALPHA_TO_COVERAGE)}function hn(k){L!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),L=k)}function Ut(k){k!==bp?(Me(n.CULL_FACE),k!==D&&(k===wu?n.cullFace(n.BACK):k===Mp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$e(n.CULL_FACE),D=k}function En(k){k!==G&&(N&&n.lineWidth(k),G=k)}function wt(k,oe,se){k?(Me(n.POLYGON_OFFSET_FILL),(P!==oe||W!==se)&&(P=oe,W=se,o.getReversed()&&(oe=-oe,se=-se),n.polygonOffset(oe,se))):$e(n.POLYGON_OFFSET_FILL)}function xn(k){k?Me(n.SCISSOR_TEST):$e(n.SCISSOR_TEST)}function nn(k){k===void 0&&(k=n.TEXTURE0+O-1),Z!==k&&(n.activeTexture(k),Z=k)}function un(k,oe,se){se===void 0&&(Z===null?se=n.TEXTURE0+O-1:se=Z);let Te=ne[se];Te===void 0&&(Te={type:void 0,texture:void 0},ne[se]=Te),(Te.type!==k||Te.texture!==oe)&&(Z!==se&&(n.activeTexture(se),Z=se),n.bindTexture(k,oe||Ce[k]),Te.type=k,Te.texture=oe)}function z(){let k=ne[Z];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(k){it("WebGLState:",k)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(k){it("WebGLState:",k)}}function ht(){try{n.texSubImage2D(...arguments)}catch(k){it("WebGLState:",k)}}function we(){try{n.texSubImage3D(...arguments)}catch(k){it("WebGLState:",k)}}function kt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){it("WebGLState:",k)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(k){it("WebGLState:",k)}}function Ye(){try{n.texStorage2D(...arguments)}catch(k){it("WebGLState:",k)}}function C(){try{n.texStorage3D(...arguments)}catch(k){it("WebGLState:",k)}}function S(){try{n.texImage2D(...arguments)}catch(k){it("WebGLState:",k)}}function q(){try{n.texImage3D(...arguments)}catch(k){it("WebGLState:",k)}}function he(k){return f[k]!==void 0?f[k]:n.getParameter(k)}function ae(k,oe){f[k]!==oe&&(n.pixelStorei(k,oe),f[k]=oe)}function xe(k){te.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),te.copy(k))}function ve(k){ge.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ge.copy(k))}function ie(k,oe){let se=c.get(oe);se===void 0&&(se=new WeakMap,c.set(oe,se));let Te=se.get(k);Te===void 0&&(Te=n.getUniformBlockIndex(oe,k.name),n.uniformBlockBinding(oe,Te,Te),se.set(k,Te))}function re(k,oe,se){let _e=c.get(oe).get(k);l[_e]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,se),l[_e]=se)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Z=null,ne={},h={},l={},d=new WeakMap,p=[],y=null,g=!1,m=null,v=null,A=null,b=null,R=null,E=null,_=null,T=new ut(0,0,0),V=0,F=!1,L=null,D=null,G=null,P=null,W=null,te.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:$e,bindFramebuffer:ct,drawBuffers:He,useProgram:gt,setBlending:Jt,setMaterial:Wt,setFlipSided:hn,setCullFace:Ut,setLineWidth:En,setPolygonOffset:wt,setScissorTest:xn,activeTexture:nn,bindTexture:un,unbindTexture:z,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:S,texImage3D:q,pixelStorei:ae,getParameter:he,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Ye,texStorage3D:C,texSubImage2D:ht,texSubImage3D:we,compressedTexSubImage2D:kt,compressedTexSubImage3D:Ge,scissor:xe,viewport:ve,reset:me}}function LM(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,y=new FinalizationRegistry(C=>p.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,S){return g?new OffscreenCanvas(C,S):oa("canvas")}function v(C,S,q){let he=1,ae=Ye(C);if((ae.width>q||ae.height>q)&&(he=q/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let xe=Math.floor(he*ae.width),ve=Math.floor(he*ae.height);h===void 0&&(h=m(xe,ve));let ie=S?m(xe,ve):h;return ie.width=xe,ie.height=ve,ie.getContext("2d").drawImage(C,0,0,xe,ve),je("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+xe+"x"+ve+")."),ie}else return"data"in C&&je("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),C;return C}function A(C){return C.generateMipmaps}function b(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(C,S,q,he,ae,xe=!1){if(C!==null){if(n[C]!==void 0)return n[C];je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=S;if(S===n.RED&&(q===n.FLOAT&&(ie=n.R32F),q===n.HALF_FLOAT&&(ie=n.R16F),q===n.UNSIGNED_BYTE&&(ie=n.R8),q===n.UNSIGNED_SHORT&&ve&&(ie=ve.R16_EXT),q===n.SHORT&&ve&&(ie=ve.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.R8UI),q===n.UNSIGNED_SHORT&&(ie=n.R16UI),q===n.UNSIGNED_INT&&(ie=n.R32UI),q===n.BYTE&&(ie=n.R8I),q===n.SHORT&&(ie=n.R16I),q===n.INT&&(ie=n.R32I)),S===n.RG&&(q===n.FLOAT&&(ie=n.RG32F),q===n.HALF_FLOAT&&(ie=n.RG16F),q===n.UNSIGNED_BYTE&&(ie=n.RG8),q===n.UNSIGNED_SHORT&&ve&&(ie=ve.RG16_EXT),q===n.SHORT&&ve&&(ie=ve.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.RG8UI),q===n.UNSIGNED_SHORT&&(ie=n.RG16UI),q===n.UNSIGNED_INT&&(ie=n.RG32UI),q===n.BYTE&&(ie=n.RG8I),q===n.SHORT&&(ie=n.RG16I),q===n.INT&&(ie=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),q===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),q===n.UNSIGNED_INT&&(ie=n.RGB32UI),q===n.BYTE&&(ie=n.RGB8I),q===n.SHORT&&(ie=n.RGB16I),q===n.INT&&(ie=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),q===n.UNSIGNED_INT&&(ie=n.RGBA32UI),q===n.BYTE&&(ie=n.RGBA8I),q===n.SHORT&&(ie=n.RGBA16I),q===n.INT&&(ie=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&ve&&(ie=ve.RGB16_EXT),q===n.SHORT&&ve&&(ie=ve.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),S===n.RGBA){let re=xe?ra:bt.getTransfer(ae);q===n.FLOAT&&(ie=n.RGBA32F),q===n.HALF_FLOAT&&(ie=n.RGBA16F),q===n.UNSIGNED_BYTE&&(ie=re===Pt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ve&&(ie=ve.RGBA16_EXT),q===n.SHORT&&ve&&(ie=ve.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function _(C,S){let q;return C?S===null||S===Ui||S===Sr?q=n.DEPTH24_STENCIL8:S===Fi?q=n.DEPTH32F_STENCIL8:S===bo&&(q=n.DEPTH24_STENCIL8,je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Ui||S===Sr?q=n.DEPTH_COMPONENT24:S===Fi?q=n.DEPTH_COMPONENT32F:S===bo&&(q=n.DEPTH_COMPONENT16),q}function T(C,S){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==Ln&&C.minFilter!==Jn?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function V(C){let S=new WeakRef(C);i.get(C).__ref=S,p.add(S),y.register(C,S,S)}function F(C){let S=i.get(C).__ref;S!==void 0&&(p.delete(S),y.unregister(S))}function L(C){G(C.target)}function D(C){P(C.target)}function G(C){C.removeEventListener("dispose",L),F(C),O(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&f.delete(C)}function P(C){C.removeEventListener("dispose",D),F(C),j(C)}function W(){for(let C of p){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):G(S))}p.clear(),f.clear()}function O(C){let S=i.get(C);if(S.__webglInit===void 0)return;let q=C.source,he=d.get(q);if(he){let ae=he[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&N(C),Object.keys(he).length===0&&d.delete(q)}i.remove(C)}function N(C){let S=i.get(C);n.deleteTexture(S.__webglTexture);let q=C.source,he=d.get(q);delete he[S.__cacheKey],o.memory.textures--}function j(C){let S=i.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&G(q),C.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let xe=0;xe<S.__webglFramebuffer[ae].length;xe++)n.deleteFramebuffer(S.__webglFramebuffer[ae][xe]);else n.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)n.deleteFramebuffer(S.__webglFramebuffer[ae]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let he=C.textures;for(let ae=0,xe=he.length;ae<xe;ae++){let ve=i.get(he[ae]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(he[ae])}i.remove(C)}let $=0;function Z(){$=0}function ne(){return $}function fe(C){$=C}function ue(){let C=$;return C>=s.maxTextures&&je("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,C}function te(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function ge(C,S){let q=i.get(C);if(C.isVideoTexture&&kt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let he=C.image;if(he===null)je("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)je("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(q,C,S);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function ye(C,S){let q=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Wt(q,C,S);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function Ce(C,S){let q=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Wt(q,C,S);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function Me(C,S){let q=i.get(C);if(C.version>0&&q.__version!==C.version){hn(q,C,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let $e={[zl]:n.REPEAT,[Ji]:n.CLAMP_TO_EDGE,[Vl]:n.MIRRORED_REPEAT},ct={[Ln]:n.NEAREST,[$p]:n.NEAREST_MIPMAP_NEAREST,[Aa]:n.NEAREST_MIPMAP_LINEAR,[Jn]:n.LINEAR,[gc]:n.LINEAR_MIPMAP_NEAREST,[As]:n.LINEAR_MIPMAP_LINEAR},He={[Zp]:n.NEVER,[qu]:n.ALWAYS,[jp]:n.LESS,[$u]:n.LEQUAL,[Jp]:n.EQUAL,[Xu]:n.GEQUAL,[Kp]:n.GREATER,[Qp]:n.NOTEQUAL};function gt(C,S){if(S.type===Fi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Jn||S.magFilter===gc||S.magFilter===Aa||S.magFilter===As||S.minFilter===Jn||S.minFilter===gc||S.minFilter===Aa||S.minFilter===As)&&je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,$e[S.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,$e[S.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,$e[S.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,ct[S.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,ct[S.minFilter]),S.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,He[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Ln||S.minFilter!==Aa&&S.minFilter!==As||S.type===Fi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function dt(C,S){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",L),V(S));let he=S.source,ae=d.get(he);ae===void 0&&(ae={},d.set(he,ae));let xe=te(S);if(xe!==C.__cacheKey){ae[xe]===void 0&&(ae[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[xe].usedTimes++;let ve=ae[C.__cacheKey];ve!==void 0&&(ae[C.__cacheKey].usedTimes--,ve.usedTimes===0&&N(S)),C.__cacheKey=xe,C.__webglTexture=ae[xe].texture}return q}function at(C,S,q){return Math.floor(Math.floor(C/q)/S)}function Jt(C,S,q,he){let xe=C.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,he,S.data);else{xe.sort((k,oe)=>k.start-oe.start);let ve=0;for(let k=1;k<xe.length;k++){let oe=xe[ve],se=xe[k],Te=oe.start+oe.count,_e=at(se.start,S.width,4),be=at(oe.start,S.width,4);se.start<=Te+1&&_e===be&&at(se.start+se.count-1,S.width,4)===_e?oe.count=Math.max(oe.count,se.start+se.count-oe.start):(++ve,xe[ve]=se)}xe.length=ve+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let k=0,oe=xe.length;k<oe;k++){let se=xe[k],Te=Math.floor(se.start/4),_e=Math.ceil(se.count/4),be=Te%S.width,We=Math.floor(Te/S.width),tt=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,be,We,tt,ce,q,he,S.data)}C.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Wt(C,S,q){let he=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(he=n.TEXTURE_3D);let ae=dt(C,S),xe=S.source;t.bindTexture(he,C.__webglTexture,n.TEXTURE0+q);let ve=i.get(xe);if(xe.version!==ve.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=bt.getPrimaries(bt.workingColorSpace),ke=S.colorSpace===Rs?null:bt.getPrimaries(S.colorSpace),nt=S.colorSpace===Rs||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let re=v(S.image,!1,s.maxTextureSize);re=Ge(S,re);let me=r.convert(S.format,S.colorSpace),k=r.convert(S.type),oe=E(S.internalFormat,me,k,S.normalized,S.colorSpace,S.isVideoTexture);gt(he,S);let se,Te=S.mipmaps,_e=S.isVideoTexture!==!0,be=ve.__version===void 0||ae===!0,We=xe.dataReady,tt=T(S,re);if(S.isDepthTexture)oe=_(S.format===Cs,S.type),be&&(_e?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,me,k,null));else if(S.isDataTexture)if(Te.length>0){_e&&be&&t.texStorage2D(n.TEXTURE_2D,tt,oe,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)se=Te[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,se.width,se.height,me,k,se.data):t.texImage2D(n.TEXTURE_2D,ce,oe,se.width,se.height,0,me,k,se.data);S.generateMipmaps=!1}else _e?(be&&t.texStorage2D(n.TEXTURE_2D,tt,oe,re.width,re.height),We&&Jt(S,re,me,k)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,me,k,re.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,oe,Te[0].width,Te[0].height,re.depth);for(let ce=0,ke=Te.length;ce<ke;ce++)if(se=Te[ce],S.format!==Bi)if(me!==null)if(_e){if(We)if(S.layerUpdates.size>0){let nt=sf(se.width,se.height,S.format,S.type);for(let Re of S.layerUpdates){let ft=se.data.subarray(Re*nt/se.data.BYTES_PER_ELEMENT,(Re+1)*nt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,se.width,se.height,1,me,ft)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,se.width,se.height,re.depth,me,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,oe,se.width,se.height,re.depth,0,se.data,0,0);else je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,se.width,se.height,re.depth,me,k,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,oe,se.width,se.height,re.depth,0,me,k,se.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&be&&t.texStorage2D(n.TEXTURE_2D,tt,oe,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)se=Te[ce],S.format!==Bi?me!==null?_e?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,se.width,se.height,me,se.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,oe,se.width,se.height,0,se.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,se.width,se.height,me,k,se.data):t.texImage2D(n.TEXTURE_2D,ce,oe,se.width,se.height,0,me,k,se.data)}else if(S.isDataArrayTexture)if(_e){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,oe,re.width,re.height,re.depth),We)if(S.layerUpdates.size>0){let ce=sf(re.width,re.height,S.format,S.type);for(let ke of S.layerUpdates){let nt=re.data.subarray(ke*ce/re.data.BYTES_PER_ELEMENT,(ke+1)*ce/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,re.width,re.height,1,me,k,nt)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,me,k,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,me,k,re.data);else if(S.isData3DTexture)_e?(be&&t.texStorage3D(n.TEXTURE_3D,tt,oe,re.width,re.height,re.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,me,k,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,me,k,re.data);else if(S.isFramebufferTexture){if(be)if(_e)t.texStorage2D(n.TEXTURE_2D,tt,oe,re.width,re.height);else{let ce=re.width,ke=re.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,oe,ce,ke,0,me,k,null),ce>>=1,ke>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),re.parentNode!==ce){ce.appendChild(re),f.add(S),ce.onpaint=ke=>{let nt=ke.changedElements;for(let Re of f)nt.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let nt=n.RGBA,Re=n.RGBA,ft=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Re,ft,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&be){let ce=Ye(Te[0]);t.texStorage2D(n.TEXTURE_2D,tt,oe,ce.width,ce.height)}for(let ce=0,ke=Te.length;ce<ke;ce++)se=Te[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,k,se):t.texImage2D(n.TEXTURE_2D,ce,oe,me,k,se);S.generateMipmaps=!1}else if(_e){if(be){let ce=Ye(re);t.texStorage2D(n.TEXTURE_2D,tt,oe,ce.width,ce.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,k,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,me,k,re);A(S)&&S.mipmapsAutoUpdate===!0&&b(he),ve.__version=xe.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function hn(C,S,q){if(S.image.length!==6)return;let he=dt(C,S),ae=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+q);let xe=i.get(ae);if(ae.version!==xe.__version||he===!0){t.activeTexture(n.TEXTURE0+q);let ve=bt.getPrimaries(bt.workingColorSpace),ie=S.colorSpace===Rs?null:bt.getPrimaries(S.colorSpace),re=S.colorSpace===Rs||ve===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,k=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Re=0;Re<6;Re++)!me&&!k?oe[Re]=v(S.image[Re],!0,s.maxCubemapSize):oe[Re]=k?S.image[Re].image:S.image[Re],oe[Re]=Ge(S,oe[Re]);let se=oe[0],Te=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),be=E(S.internalFormat,Te,_e,S.normalized,S.colorSpace),We=S.isVideoTexture!==!0,tt=xe.__version===void 0||he===!0,ce=ae.dataReady,ke=T(S,se);gt(n.TEXTURE_CUBE_MAP,S);let nt;if(S.isDepthTexture){if(be=_(S.format===Cs,S.type),tt)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,se.width,se.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,se.width,se.height,0,Te,_e,null)}else if(me){We&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,se.width,se.height);for(let Re=0;Re<6;Re++){nt=oe[Re].mipmaps;for(let ft=0;ft<nt.length;ft++){let $t=nt[ft];S.format!==Bi?Te!==null?We?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft,0,0,$t.width,$t.height,Te,$t.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft,be,$t.width,$t.height,0,$t.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft,0,0,$t.width,$t.height,Te,_e,$t.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft,be,$t.width,$t.height,0,Te,_e,$t.data)}}}else{if(nt=S.mipmaps,We&&tt){nt.length>0&&ke++;let Re=Ye(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(k){We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,oe[Re].width,oe[Re].height,Te,_e,oe[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,oe[Re].width,oe[Re].height,0,Te,_e,oe[Re].data);for(let ft=0;ft<nt.length;ft++){let $n=nt[ft].image[Re].image;We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft+1,0,0,$n.width,$n.height,Te,_e,$n.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft+1,be,$n.width,$n.height,0,Te,_e,$n.data)}}else{We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Te,_e,oe[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,Te,_e,oe[Re]);for(let ft=0;ft<nt.length;ft++){let $t=nt[ft];We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft+1,0,0,Te,_e,$t.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ft+1,be,Te,_e,$t.image[Re])}}}A(S)&&S.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),xe.__version=ae.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Ut(C,S,q,he,ae,xe){let ve=r.convert(q.format,q.colorSpace),ie=r.convert(q.type),re=E(q.internalFormat,ve,ie,q.normalized,q.colorSpace),me=i.get(S),k=i.get(q);if(k.__renderTarget=S,!me.__hasExternalTextures){let oe=Math.max(1,S.width>>xe),se=Math.max(1,S.height>>xe);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,xe,re,oe,se,S.depth,0,ve,ie,null):t.texImage2D(ae,xe,re,oe,se,0,ve,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,C),we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,ae,k.__webglTexture,0,ht(S)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,ae,k.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function En(C,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,C),S.depthBuffer){let he=S.depthTexture,ae=he&&he.isDepthTexture?he.type:null,xe=_(S.stencilBuffer,ae),ve=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(S),xe,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(S),xe,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,xe,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,C)}else{let he=S.textures;for(let ae=0;ae<he.length;ae++){let xe=he[ae],ve=r.convert(xe.format,xe.colorSpace),ie=r.convert(xe.type),re=E(xe.internalFormat,ve,ie,xe.normalized,xe.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(S),re,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(S),re,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,re,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function wt(C,S,q){let he=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(S.depthTexture);ae.__renderTarget=S;let xe=he?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||xe.width!==S.width||xe.height!==S.height)&&(xe.width=S.width,xe.height=S.height,S.depthTexture.needsUpdate=!0),he?Me(S.depthTexture,0):ge(S.depthTexture,0);let ve=ae.__webglTexture,ie=ht(S),re=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=S.depthTexture.format===Cs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ms)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,ve,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,ve,0);else if(S.depthTexture.format===Cs)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,ve,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(C){let S=i.get(C),q=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let he=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),he){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=he}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let he=0;he<6;he++)wt(S.__webglFramebuffer[he],C,he);else C.texture.mipmaps.length>0?wt(S.__webglFramebuffer[0],C,0):wt(S.__webglFramebuffer,C,0);else if(q){S.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[he]),S.__webglDepthbuffer[he]===void 0)S.__webglDepthbuffer[he]=n.createRenderbuffer(),En(S.__webglDepthbuffer[he],C,!1);else{let ae=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),En(S.__webglDepthbuffer,C,!1);else{let ae=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function nn(C,S,q){let he=i.get(C);S!==void 0&&Ut(he.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&xn(C)}function un(C){let S=C.texture,q=i.get(C),he=i.get(S);C.addEventListener("dispose",D),V(C);let ae=C.textures,xe=C.isWebGLCubeRenderTarget===!0,ve=ae.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=S.version,o.memory.textures++),xe){q.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(S.mipmaps.length>0){q.__webglFramebuffer[ie]=[];for(let re=0;re<S.mipmaps.length;re++)q.__webglFramebuffer[ie][re]=n.createFramebuffer()}else q.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let ie=0;ie<S.mipmaps.length;ie++)q.__webglFramebuffer[ie]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ie=0,re=ae.length;ie<re;ie++){let me=i.get(ae[ie]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&we(C)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ie=0;ie<ae.length;ie++){let re=ae[ie];q.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[ie]);let me=r.convert(re.format,re.colorSpace),k=r.convert(re.type),oe=E(re.internalFormat,me,k,re.normalized,re.colorSpace,C.isXRRenderTarget===!0),se=ht(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,oe,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,q.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),En(q.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),gt(n.TEXTURE_CUBE_MAP,S);for(let ie=0;ie<6;ie++)if(S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ut(q.__webglFramebuffer[ie][re],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Ut(q.__webglFramebuffer[ie],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);A(S)?b(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ie=0,re=ae.length;ie<re;ie++){let me=ae[ie],k=i.get(me),oe=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(oe=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,k.__webglTexture),gt(oe,me),Ut(q.__webglFramebuffer,C,me,n.COLOR_ATTACHMENT0+ie,oe,0),A(me)&&b(oe)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ie=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,he.__webglTexture),gt(ie,S),S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ut(q.__webglFramebuffer[re],C,S,n.COLOR_ATTACHMENT0,ie,re);else Ut(q.__webglFramebuffer,C,S,n.COLOR_ATTACHMENT0,ie,0);A(S)?b(ie):S.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&xn(C)}function z(C){let S=C.textures;for(let q=0,he=S.length;q<he;q++){let ae=S[q];if(A(ae)&&ae.mipmapsAutoUpdate===!0){let xe=R(C),ve=i.get(ae).__webglTexture;t.bindTexture(xe,ve),b(xe),t.unbindTexture()}}}let Pe=[];function Je(C){if(C.samples>0){if(we(C)===!1){let S=C.textures,q=C.width,he=C.height,ae=n.COLOR_BUFFER_BIT,xe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(C),ie=S.length>1;if(ie)for(let me=0;me<S.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<S.length;me++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let k=i.get(S[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,q,he,0,0,q,he,ae,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+me),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Pe.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let me=0;me<S.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let k=i.get(S[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ht(C){return Math.min(s.maxSamples,C.samples)}function we(C){let S=i.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function kt(C){let S=o.render.frame;u.get(C)!==S&&(u.set(C,S),C.update())}function Ge(C,S){let q=C.colorSpace,he=C.format,ae=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==sa&&q!==Rs&&(bt.getTransfer(q)===Pt?(he!==Bi||ae!==ni)&&je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",q)),S}function Ye(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Z,this.getTextureUnits=ne,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Ce,this.setTextureCube=Me,this.rebindTextures=nn,this.setupRenderTarget=un,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=we,this.dispose=W}function DM(n,e){function t(i,s=Rs){let r,o=bt.getTransfer(s);if(i===ni)return n.UNSIGNED_BYTE;if(i===xc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===yc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===zu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Vu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Bu)return n.BYTE;if(i===ku)return n.SHORT;if(i===bo)return n.UNSIGNED_SHORT;if(i===_c)return n.INT;if(i===Ui)return n.UNSIGNED_INT;if(i===Fi)return n.FLOAT;if(i===Oi)return n.HALF_FLOAT;if(i===Gu)return n.ALPHA;if(i===Hu)return n.RGB;if(i===Bi)return n.RGBA;if(i===Ms)return n.DEPTH_COMPONENT;if(i===Cs)return n.DEPTH_STENCIL;if(i===Wu)return n.RED;if(i===vc)return n.RED_INTEGER;if(i===nr)return n.RG;if(i===Sc)return n.RG_INTEGER;if(i===bc)return n.RGBA_INTEGER;if(i===Ca||i===Ra||i===Pa||i===Ia)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Mc||i===wc||i===Tc||i===Ec)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Mc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Tc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ec)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ac||i===Cc||i===Rc||i===Pc||i===Ic||i===La||i===Lc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ac||i===Cc)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Rc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Pc)return r.COMPRESSED_R11_EAC;if(i===Ic)return r.COMPRESSED_SIGNED_R11_EAC;if(i===La)return r.COMPRESSED_RG11_EAC;if(i===Lc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Dc||i===Nc||i===Uc||i===Fc||i===Oc||i===Bc||i===kc||i===zc||i===Vc||i===Gc||i===Hc||i===Wc||i===$c||i===Xc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Dc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Nc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Uc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Fc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Oc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Bc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===kc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===zc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Vc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Gc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Hc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Wc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===$c)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Xc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===qc||i===Yc||i===Zc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===qc)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Yc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Zc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===jc||i===Jc||i===Da||i===Kc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===jc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Jc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Da)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Kc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Sr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var NM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,UM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,xf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new pa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ts({vertexShader:NM,fragmentShader:UM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new bi(new ma(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},yf=class extends Ni{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,y=typeof XRWebGLBinding<"u",g=new xf,m={},v=t.getContextAttributes(),A=null,b=null,R=[],E=[],_=new Ke,T=null,V=null,F=new jn;F.viewport=new Qt;let L=new jn;L.viewport=new Qt;let D=[F,L],G=new uc,P=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let ge=R[te];return ge===void 0&&(ge=new uo,R[te]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(te){let ge=R[te];return ge===void 0&&(ge=new uo,R[te]=ge),ge.getGripSpace()},this.getHand=function(te){let ge=R[te];return ge===void 0&&(ge=new uo,R[te]=ge),ge.getHandSpace()};function O(te){let ge=E.indexOf(te.inputSource);if(ge===-1)return;let ye=R[ge];ye!==void 0&&(ye.update(te.inputSource,te.frame,c||o),ye.dispatchEvent({type:te.type,data:te.inputSource}))}function N(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",N),s.removeEventListener("inputsourceschange",j);for(let te=0;te<R.length;te++){let ge=E[te];ge!==null&&(E[te]=null,R[te].disconnect(ge))}P=null,W=null,g.reset();for(let te in m)delete m[te];if(e.setRenderTarget(A),d=null,h=null,f=null,s=null,b=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(_.width,_.height,!1),V!==null){let te=V.camera;te.fov=V.fov,te.zoom=V.zoom,te.updateProjectionMatrix(),V=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,i.isPresenting===!0&&je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,i.isPresenting===!0&&je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(te){c=te},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",N),s.addEventListener("inputsourceschange",j),v.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ce=null,Me=null;v.depth&&(Me=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=v.stencil?Cs:Ms,Ce=v.stencil?Sr:Ui);let $e={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer($e),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new fi(h.textureWidth,h.textureHeight,{format:Bi,type:ni,depthTexture:new Es(h.textureWidth,h.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ye={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new fi(d.framebufferWidth,d.framebufferHeight,{format:Bi,type:ni,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function j(te){for(let ge=0;ge<te.removed.length;ge++){let ye=te.removed[ge],Ce=E.indexOf(ye);Ce>=0&&(E[Ce]=null,R[Ce].disconnect(ye))}for(let ge=0;ge<te.added.length;ge++){let ye=te.added[ge],Ce=E.indexOf(ye);if(Ce===-1){for(let $e=0;$e<R.length;$e++)if($e>=E.length){E.push(ye),Ce=$e;break}else if(E[$e]===null){E[$e]=ye,Ce=$e;break}if(Ce===-1)break}let Me=R[Ce];Me&&Me.connect(ye)}}function $(te,ge){ge===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(ge.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let ge=te.near,ye=te.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(ye=g.depthFar)),G.near=L.near=F.near=ge,G.far=L.far=F.far=ye,(P!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),P=G.near,W=G.far),G.layers.mask=te.layers.mask|6,F.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Ce=te.parent,Me=G.cameras;$(G,Ce);for(let $e=0;$e<Me.length;$e++)$(Me[$e],Ce);G.projectionMatrix.copy(F.projectionMatrix),G.projectionMatrixInverse.copy(F.projectionMatrixInverse),V===null&&te.isPerspectiveCamera&&(V={camera:te,fov:te.fov,zoom:te.zoom}),Z(te,G,Ce)};function Z(te,ge,ye){ye===null?te.matrix.copy(ge.matrixWorld):(te.matrix.copy(ye.matrixWorld),te.matrix.invert(),te.matrix.multiply(ge.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(ge.projectionMatrix),te.projectionMatrixInverse.copy(ge.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=lo*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(te){l=te,h!==null&&(h.fixedFoveation=te),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=te)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(G)},this.getCameraTexture=function(te){return m[te]};let ne=null;function fe(te,ge){if(u=ge.getViewerPose(c||o),p=ge,u!==null){let ye=u.views;d!==null&&(e.setRenderTargetFramebuffer(b,d.framebuffer),e.setRenderTarget(b));let Ce=!1;ye.length!==G.cameras.length&&(G.cameras.length=0,Ce=!0);for(let He=0;He<ye.length;He++){let gt=ye[He],dt=null;if(d!==null)dt=d.getViewport(gt);else{let Jt=f.getViewSubImage(h,gt);dt=Jt.viewport,He===0&&(e.setRenderTargetTextures(b,Jt.colorTexture,Jt.depthStencilTexture),e.setRenderTarget(b))}let at=D[He];at===void 0&&(at=new jn,at.layers.enable(He),at.viewport=new Qt,D[He]=at),at.matrix.fromArray(gt.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(gt.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(dt.x,dt.y,dt.width,dt.height),He===0&&(G.matrix.copy(at.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ce===!0&&G.cameras.push(at)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();let He=f.getDepthInformation(ye[0]);He&&He.isValid&&He.texture&&g.init(He,s.renderState)}if(Me&&Me.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let He=0;He<ye.length;He++){let gt=ye[He].camera;if(gt){let dt=m[gt];dt||(dt=new pa,m[gt]=dt);let at=f.getCameraImage(gt);dt.sourceTexture=at}}}}for(let ye=0;ye<R.length;ye++){let Ce=E[ye],Me=R[ye];Ce!==null&&Me!==void 0&&Me.update(Ce,ge,c||o)}ne&&ne(te,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),p=null}let ue=new Lm;ue.setAnimationLoop(fe),this.setAnimationLoop=function(te){ne=te},this.dispose=function(){}}},FM=new zt,Gm=new ot;Gm.set(-1,0,0,0,1,0,0,0,1);function OM(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,ef(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,v,A,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),f(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&d(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),y(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,v,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Qn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Qn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let v=e.get(m),A=v.envMap,b=v.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(FM.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Gm),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,v,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*v,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function f(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,v){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Qn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function y(g,m){let v=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function BM(n,e,t,i){let s={},r={};function o(v,A){let b=A.program;i.uniformBlockBinding(v,b,s[v.id])}function a(v,A){let b=s[v.id];b===void 0&&(p(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",g));let R=A.program;i.updateUBOMapping(v,R);let E=e.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let A=n.createBuffer(),b=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,b,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],b=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let E=0,_=b.length;E<_;E++){let T=b[E];if(Array.isArray(T))for(let V=0,F=T.length;V<F;V++)u(T[V],E,V,R);else u(T,E,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,A,b,R){if(h(v,A,b,R)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let T=0;for(let V=0;V<_.length;V++){let F=_[V],L=y(F,!0);f(F,v.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,v.__data)}}function f(v,A,b){typeof v=="number"||typeof v=="boolean"?A[b]=v:v.isMatrix3?(A[b]=v.elements[0],A[b+1]=v.elements[1],A[b+2]=v.elements[2],A[b+3]=0,A[b+4]=v.elements[3],A[b+5]=v.elements[4],A[b+6]=v.elements[5],A[b+7]=0,A[b+8]=v.elements[6],A[b+9]=v.elements[7],A[b+10]=v.elements[8],A[b+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-b),b):v.toArray(A,b)}function h(v,A,b,R){let E=v.value,_=A+"_"+b;if(Array.isArray(E)){R[_]===void 0&&(R[_]=[]);let T=R[_],V=!1;for(let F=0;F<E.length;F++)d(E[F],T,F)===!0&&(V=!0);return V}return d(E,R,_)}function d(v,A,b){if(A[b]===void 0)return typeof v=="number"||typeof v=="boolean"?A[b]=v:ArrayBuffer.isView(v)?A[b]=v.slice():A[b]=v.clone(),!0;{let R=A[b];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return A[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function p(v){let A=v.uniforms,b=0,R=16;for(let _=0,T=A.length;_<T;_++){let V=Array.isArray(A[_])?A[_]:[A[_]];for(let F=0,L=V.length;F<L;F++){let D=V[F],G=Array.isArray(D.value)?D.value:[D.value],P=Array.isArray(A[_])||Array.isArray(D.value),W=b;for(let N=0,j=G.length;N<j;N++){let $=G[N],Z=y($,P),ne=b%R,fe=ne%Z.boundary,ue=ne+fe;b+=fe,ue!==0&&R-ue<Z.storage&&(b+=R-ue),N===0&&(W=b),b+=Z.storage}let O=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new O((b-W)/Float32Array.BYTES_PER_ELEMENT),D.__offset=W}}let E=b%R;return E>0&&(b+=R-E),v.__size=b,v.__cache={},this}function y(v,A){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):je("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(v){let A=v.target;A.removeEventListener("dispose",g),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var kM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ss=null;function zM(){return ss===null&&(ss=new ql(kM,16,16,nr,Oi),ss.name="DFG_LUT",ss.minFilter=Jn,ss.magFilter=Jn,ss.wrapS=Ji,ss.wrapT=Ji,ss.generateMipmaps=!1,ss.needsUpdate=!0),ss}var ih=class{constructor(e={}){let{canvas:t=tm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=ni}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=d,g=new Set([bc,Sc,vc]),m=new Set([ni,Ui,bo,Sr,xc,yc]),v=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},R=null,E=null,_=[],T=[],V=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=is,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,L=!1,D=null,G=null,P=null,W=null;this._outputColorSpace=hi;let O=0,N=0,j=null,$=-1,Z=null,ne=new Qt,fe=new Qt,ue=null,te=new ut(0),ge=0,ye=t.width,Ce=t.height,Me=1,$e=null,ct=null,He=new Qt(0,0,ye,Ce),gt=new Qt(0,0,ye,Ce),dt=!1,at=new qs,Jt=new Yl,Wt=!1,hn=!1,Ut=new zt,En=new Y,wt=new Qt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function un(){return j===null?Me:1}let z=i;function Pe(w,H){return t.getContext(w,H)}let Je,ht,we,kt,Ge,Ye,C,S,q,he,ae,xe,ve,ie,re,me,k,oe,se,Te,_e,be,We;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Re,!1),z===null){let H="webgl2";if(z=Pe(H,w),z===null)throw Pe(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(w){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),it("WebGLRenderer: "+w.message),w}function tt(){Je=new JS(z),Je.init(),_e=new DM(z,Je),ht=new zS(z,Je,e,_e),we=new IM(z,Je),ht.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),G=z.createFramebuffer(),P=z.createFramebuffer(),W=z.createFramebuffer(),kt=new eb(z),Ge=new _M,Ye=new LM(z,Je,we,Ge,ht,_e,kt),C=new jS(F),S=new ny(z),be=new BS(z,S),q=new KS(z,S,kt,be),he=new nb(z,q,S,be,kt),oe=new tb(z,ht,Ye),re=new VS(Ge),ae=new gM(F,C,Je,ht,be,re),xe=new OM(F,Ge),ve=new yM,ie=new TM(Je),k=new OS(F,C,we,he,p,l),me=new PM(F,he,ht),We=new BM(z,kt,ht,we),se=new kS(z,Je,kt),Te=new QS(z,Je,kt),kt.programs=ae.programs,F.capabilities=ht,F.extensions=Je,F.properties=Ge,F.renderLists=ve,F.shadowMap=me,F.state=we,F.info=kt}y!==ni&&(V=new sb(y,t.width,t.height,a,s,r));let ce=new yf(F,z);this.xr=ce,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let w=Je.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Je.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(w){w!==void 0&&(Me=w,this.setSize(ye,Ce,!1))},this.getSize=function(w){return w.set(ye,Ce)},this.setSize=function(w,H,ee=!0){if(ce.isPresenting){je("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=w,Ce=H,t.width=Math.floor(w*Me),t.height=Math.floor(H*Me),ee===!0&&(t.style.width=w+"px",t.style.height=H+"px"),V!==null&&V.setSize(t.width,t.height),this.setViewport(0,0,w,H)},this.getDrawingBufferSize=function(w){return w.set(ye*Me,Ce*Me).floor()},this.setDrawingBufferSize=function(w,H,ee){ye=w,Ce=H,Me=ee,t.width=Math.floor(w*ee),t.height=Math.floor(H*ee),this.setViewport(0,0,w,H)},this.setEffects=function(w){if(y===ni){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let H=0;H<w.length;H++)if(w[H].isOutputPass===!0){je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}V.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ne)},this.getViewport=function(w){return w.copy(He)},this.setViewport=function(w,H,ee,J){w.isVector4?He.set(w.x,w.y,w.z,w.w):He.set(w,H,ee,J),we.viewport(ne.copy(He).multiplyScalar(un()).round())},this.getScissor=function(w){return w.copy(gt)},this.setScissor=function(w,H,ee,J){w.isVector4?gt.set(w.x,w.y,w.z,w.w):gt.set(w,H,ee,J),we.scissor(fe.copy(gt).multiplyScalar(un()).round())},this.getScissorTest=function(){return dt},this.setScissorTest=function(w){we.setScissorTest(dt=w)},this.setOpaqueSort=function(w){$e=w},this.setTransparentSort=function(w){ct=w},this.getClearColor=function(w){return w.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(w=!0,H=!0,ee=!0){let J=0;if(w){let K=!1;if(j!==null){let Ee=j.texture.format;K=g.has(Ee)}if(K){let Ee=j.texture.type,Le=m.has(Ee),Ae=k.getClearColor(),De=k.getClearAlpha(),Ve=Ae.r,st=Ae.g,_t=Ae.b;Le?(v[0]=Ve,v[1]=st,v[2]=_t,v[3]=De,z.clearBufferuiv(z.COLOR,0,v)):(A[0]=Ve,A[1]=st,A[2]=_t,A[3]=De,z.clearBufferiv(z.COLOR,0,A))}else J|=z.COLOR_BUFFER_BIT}H&&(J|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ee&&(J|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&z.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),D=w},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),k.dispose(),ve.dispose(),ie.dispose(),Ye.dispose(),Ge.dispose(),C.dispose(),he.dispose(),q.dispose(),be.dispose(),We.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Ja),ce.removeEventListener("sessionend",Hi),us.stop()};function ke(w){w.preventDefault(),Zu("WebGLRenderer: Context Lost."),L=!0}function nt(){Zu("WebGLRenderer: Context Restored."),L=!1;let w=kt.autoReset,H=me.enabled,ee=me.autoUpdate,J=me.needsUpdate,K=me.type;tt(),kt.autoReset=w,me.enabled=H,me.autoUpdate=ee,me.needsUpdate=J,me.type=K}function Re(w){it("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function ft(w){let H=w.target;H.removeEventListener("dispose",ft),$t(H)}function $t(w){$n(w),Ge.remove(w)}function $n(w){let H=Ge.get(w).programs;H!==void 0&&(H.forEach(function(ee){ae.releaseProgram(ee)}),w.isShaderMaterial&&ae.releaseShaderCache(w))}this.renderBufferDirect=function(w,H,ee,J,K,Ee){H===null&&(H=xn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ae=Ho(w,H,ee,J,K);we.setMaterial(J,Le);let De=ee.index,Ve=1;if(J.wireframe===!0){if(De=q.getWireframeAttribute(ee),De===void 0)return;Ve=2}let st=ee.drawRange,_t=ee.attributes.position,ze=st.start*Ve,xt=(st.start+st.count)*Ve;Ee!==null&&(ze=Math.max(ze,Ee.start*Ve),xt=Math.min(xt,(Ee.start+Ee.count)*Ve)),De!==null?(ze=Math.max(ze,0),xt=Math.min(xt,De.count)):_t!=null&&(ze=Math.max(ze,0),xt=Math.min(xt,_t.count));let en=xt-ze;if(en<0||en===1/0)return;be.setup(K,J,Ae,ee,De);let Lt,Dt=se;if(De!==null&&(Lt=S.get(De),Dt=Te,Dt.setIndex(Lt)),K.isMesh)J.wireframe===!0?(we.setLineWidth(J.wireframeLinewidth*un()),Dt.setMode(z.LINES)):Dt.setMode(z.TRIANGLES);else if(K.isLine){let yn=J.linewidth;yn===void 0&&(yn=1),we.setLineWidth(yn*un()),K.isLineSegments?Dt.setMode(z.LINES):K.isLineLoop?Dt.setMode(z.LINE_LOOP):Dt.setMode(z.LINE_STRIP)}else K.isPoints?Dt.setMode(z.POINTS):K.isSprite&&Dt.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Dt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let yn=K._multiDrawStarts,Oe=K._multiDrawCounts,fn=K._multiDrawCount,St=De?S.get(De).bytesPerElement:1,ds=Ge.get(J).currentProgram.getUniforms();for(let dn=0;dn<fn;dn++)ds.setValue(z,"_gl_DrawID",dn),Dt.render(yn[dn]/St,Oe[dn])}else if(K.isInstancedMesh)Dt.renderInstances(ze,en,K.count);else if(ee.isInstancedBufferGeometry){let yn=ee._maxInstanceCount!==void 0?ee._maxInstanceCount:1/0,Oe=Math.min(ee.instanceCount,yn);Dt.renderInstances(ze,en,Oe)}else Dt.render(ze,en)};function zo(w,H,ee,J){D!==null&&w.isNodeMaterial&&D.setObject(J,w),Wt===!0&&re.setState(w,ee,!1),w.transparent===!0&&w.side===ns&&w.forceSinglePass===!1?(w.side=Qn,w.needsUpdate=!0,Wi(w,H,J),w.side=tr,w.needsUpdate=!0,Wi(w,H,J),w.side=ns):Wi(w,H,J)}this.compile=function(w,H,ee=null){ee===null&&(ee=w),D!==null&&D.renderStart(w,H,ee),E=ie.get(ee),E.init(H),T.push(E),ee.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),w!==ee&&w.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),E.setupLights(),D!==null&&D.updateLights(E.state.lightsArray),hn=this.localClippingEnabled,Wt=re.init(this.clippingPlanes,hn),Wt===!0&&re.setGlobalState(this.clippingPlanes,H),D!==null&&me.render(E.state.shadowsArray,ee,H);let J=new Set;return w.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Ae=Ee[Le];zo(Ae,ee,H,K),J.add(Ae)}else zo(Ee,ee,H,K),J.add(Ee)}),E=T.pop(),D!==null&&D.renderEnd(),J},this.compileAsync=function(w,H,ee=null){let J=this.compile(w,H,ee);return new Promise(K=>{function Ee(){if(J.forEach(function(Le){let De=Ge.get(Le).currentProgram;(De===void 0||De.isReady())&&J.delete(Le)}),J.size===0){K(w);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Dr=null;function Uh(w){Dr&&Dr(w)}function Ja(){us.stop()}function Hi(){us.start()}let us=new Lm;us.setAnimationLoop(Uh),typeof self<"u"&&us.setContext(self),this.setAnimationLoop=function(w){Dr=w,ce.setAnimationLoop(w),w===null?us.stop():us.start()},ce.addEventListener("sessionstart",Ja),ce.addEventListener("sessionend",Hi),this.render=function(w,H){if(H!==void 0&&H.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;D!==null&&D.renderStart(w,H);let ee=ce.enabled===!0&&ce.isPresenting===!0,J=V!==null&&(j===null||ee)&&V.begin(F,j);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(V===null||V.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(H),H=ce.getCamera()),w.isScene===!0&&w.onBeforeRender(F,w,H,j),E=ie.get(w,T.length),E.init(H),E.state.textureUnits=Ye.getTextureUnits(),T.push(E),Ut.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Jt.setFromArrayCamera(H):at.setFromProjectionMatrix(Ut,Si,H.reversedDepth),hn=this.localClippingEnabled,Wt=re.init(this.clippingPlanes,hn),R=ve.get(w,_.length),R.init(),_.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=F.xr.getDepthSensingMesh();Le!==null&&fs(Le,H,-1/0,F.sortObjects)}fs(w,H,0,F.sortObjects),R.finish(),D!==null&&D.updateLights(E.state.lightsArray),F.sortObjects===!0&&R.sort($e,ct),nn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,nn&&k.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&re.beginShadows();let K=E.state.shadowsArray;if(me.render(K,w,H),Wt===!0&&re.endShadows(),(J&&V.hasRenderPass())===!1){let Le=R.opaque,Ae=R.transmissive;if(E.setupLights(),H.isArrayCamera){let De=H.cameras;if(Ae.length>0)for(let Ve=0,st=De.length;Ve<st;Ve++){let _t=De[Ve];Ai(Le,Ae,w,_t)}nn&&k.render(w);for(let Ve=0,st=De.length;Ve<st;Ve++){let _t=De[Ve];Vo(R,w,_t,_t.viewport)}}else Ae.length>0&&Ai(Le,Ae,w,H),nn&&k.render(w),Vo(R,w,H)}j!==null&&N===0&&(Ye.updateMultisampleRenderTarget(j),Ye.updateRenderTargetMipmap(j)),J&&V.end(F),w.isScene===!0&&w.onAfterRender(F,w,H),be.resetDefaultState(),$=-1,Z=null,T.pop(),T.length>0?(E=T[T.length-1],Ye.setTextureUnits(E.state.textureUnits),Wt===!0&&re.setGlobalState(F.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,D!==null&&D.renderEnd()};function fs(w,H,ee,J){if(w.visible===!1)return;if(w.layers.test(H.layers)){if(w.isGroup)ee=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(H);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Le=H.isArrayCamera?Jt:at;if(!w.frustumCulled||w.intersectsFrustum(Le)){J&&wt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ut);let Ae=he.update(w),De=w.material;De.visible&&R.push(w,Ae,De,ee,wt.z,null,H)}}else if(w.isMesh||w.isLine||w.isPoints){let Le=H.isArrayCamera?Jt:at;if(!w.frustumCulled||w.intersectsFrustum(Le)){let Ae=he.update(w),De=w.material;if(J&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),wt.copy(w.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),wt.copy(Ae.boundingSphere.center)),wt.applyMatrix4(w.matrixWorld).applyMatrix4(Ut)),Array.isArray(De)){let Ve=Ae.groups;for(let st=0,_t=Ve.length;st<_t;st++){let ze=Ve[st],xt=De[ze.materialIndex];xt&&xt.visible&&R.push(w,Ae,xt,ee,wt.z,ze,H)}}else De.visible&&R.push(w,Ae,De,ee,wt.z,null,H)}}}let Ee=w.children;for(let Le=0,Ae=Ee.length;Le<Ae;Le++)fs(Ee[Le],H,ee,J)}function Vo(w,H,ee,J){let{opaque:K,transmissive:Ee,transparent:Le}=w;E.setupLightsView(ee),Wt===!0&&re.setGlobalState(F.clippingPlanes,ee),J&&we.viewport(ne.copy(J)),K.length>0&&sn(K,H,ee),Ee.length>0&&sn(Ee,H,ee),Le.length>0&&sn(Le,H,ee),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Ai(w,H,ee,J){if((ee.isScene===!0?ee.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[J.id]===void 0){let ze=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[J.id]=new fi(1,1,{generateMipmaps:!0,type:ze?Oi:ni,minFilter:As,samples:Math.max(4,ht.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Ee=E.state.transmissionRenderTarget[J.id],Le=J.viewport||ne;Ee.setSize(Le.z*F.transmissionResolutionScale,Le.w*F.transmissionResolutionScale);let Ae=F.getRenderTarget(),De=F.getActiveCubeFace(),Ve=F.getActiveMipmapLevel();F.setRenderTarget(Ee),F.getClearColor(te),ge=F.getClearAlpha(),ge<1&&F.setClearColor(16777215,.5),F.clear(),nn&&k.render(ee);let st=F.toneMapping;F.toneMapping=is;let _t=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),E.setupLightsView(J),Wt===!0&&re.setGlobalState(F.clippingPlanes,J),sn(w,ee,J),Ye.updateMultisampleRenderTarget(Ee),Ye.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let xt=0,en=H.length;xt<en;xt++){let Lt=H[xt],{object:Dt,geometry:yn,material:Oe,group:fn}=Lt;if(Oe.side===ns&&Dt.layers.test(J.layers)){let St=Oe.side;Oe.side=Qn,Oe.needsUpdate=!0,ln(Dt,ee,J,yn,Oe,fn),Oe.side=St,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(Ye.updateMultisampleRenderTarget(Ee),Ye.updateRenderTargetMipmap(Ee))}F.setRenderTarget(Ae,De,Ve),F.setClearColor(te,ge),_t!==void 0&&(J.viewport=_t),F.toneMapping=st}function sn(w,H,ee){let J=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Ee=w.length;K<Ee;K++){let Le=w[K],{object:Ae,geometry:De,group:Ve}=Le,st=Le.material;st.allowOverride===!0&&J!==null&&(st=J),Ae.layers.test(ee.layers)&&ln(Ae,H,ee,De,st,Ve)}}function ln(w,H,ee,J,K,Ee){D!==null&&K.isNodeMaterial&&D.setObject(w,K),w.onBeforeRender(F,H,ee,J,K,Ee),w.modelViewMatrix.multiplyMatrices(ee.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),K.onBeforeRender(F,H,ee,J,w,Ee),K.transparent===!0&&K.side===ns&&K.forceSinglePass===!1?(K.side=Qn,K.needsUpdate=!0,F.renderBufferDirect(ee,H,J,K,w,Ee),K.side=tr,K.needsUpdate=!0,F.renderBufferDirect(ee,H,J,K,w,Ee),K.side=ns):F.renderBufferDirect(ee,H,J,K,w,Ee),w.onAfterRender(F,H,ee,J,K,Ee)}function cn(w){let H=0;for(let ee of w)ee.texture!==null&&H++;return H}function Wi(w,H,ee){H.isScene!==!0&&(H=xn);let J=Ge.get(w),K=E.state.lights,Ee=E.state.shadowsArray,Le=K.state.version,Ae=ae.getParameters(w,K.state,Ee,H,ee,E.state.lightProbeGridArray),De=ae.getProgramCacheKey(Ae),Ve=J.programs;J.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?H.environment:null,J.fog=H.fog;let st=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;J.envMap=C.get(w.envMap||J.environment,st),J.envMapRotation=J.environment!==null&&w.envMap===null?H.environmentRotation:w.envMapRotation,Ve===void 0&&(w.addEventListener("dispose",ft),Ve=new Map,J.programs=Ve,J.programVariants=new Map);let _t=Ve.get(De);if(_t!==void 0){if(J.currentProgram===_t&&J.lightsStateVersion===Le)return Go(w,Ae),_t}else Ae.uniforms=ae.getUniforms(w),D!==null&&w.isNodeMaterial&&D.build(w,ee,Ae),w.onBeforeCompile(Ae,F),_t=ae.acquireProgram(Ae,De),Ve.set(De,_t),J.uniforms=Ae.uniforms;let ze=J.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(ze.clippingPlanes=re.uniform),Go(w,Ae),J.needsLights=Ns(w),J.lightsStateVersion=Le,J.needsLights&&(ze.ambientLightColor.value=K.state.ambient,ze.lightProbe.value=K.state.probe,ze.sunLights.value=K.state.sun,ze.sunLightShadows.value=K.state.sunShadow,ze.directionalLights.value=K.state.directional,ze.directionalLightShadows.value=K.state.directionalShadow,ze.spotLights.value=K.state.spot,ze.spotLightShadows.value=K.state.spotShadow,ze.rectAreaLights.value=K.state.rectArea,ze.ltc_1.value=K.state.rectAreaLTC1,ze.ltc_2.value=K.state.rectAreaLTC2,ze.pointLights.value=K.state.point,ze.pointLightShadows.value=K.state.pointShadow,ze.hemisphereLights.value=K.state.hemi,ze.sunShadowMatrix.value=K.state.sunShadowMatrix,ze.sunShadowCascade.value=K.state.sunShadowCascade,ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ze.spotLightMatrix.value=K.state.spotLightMatrix,ze.spotLightMap.value=K.state.spotLightMap,ze.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=cn(E.state.lightProbeGridArray),J.currentProgram=_t,J.uniformsList=null,_t}function si(w,H,ee,J,K){let Ee=Ge.get(w),Le=Ee.currentProgram.id+","+J+","+K,Ae=Ee.programVariants.get(Le);return Ae===void 0?(Ae=Wi(w,H,ee),Ee.programVariants.set(Le,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=J,Ee.toneMapping=K),Ae}function Ds(w){if(w.uniformsList===null){let H=w.currentProgram.getUniforms();w.uniformsList=wo.seqWithValue(H.seq,w.uniforms)}return w.uniformsList}function Go(w,H){let ee=Ge.get(w);ee.outputColorSpace=H.outputColorSpace,ee.batching=H.batching,ee.batchingColor=H.batchingColor,ee.instancing=H.instancing,ee.instancingColor=H.instancingColor,ee.instancingMorph=H.instancingMorph,ee.skinning=H.skinning,ee.morphTargets=H.morphTargets,ee.morphNormals=H.morphNormals,ee.morphColors=H.morphColors,ee.morphTargetsCount=H.morphTargetsCount,ee.numClippingPlanes=H.numClippingPlanes,ee.numIntersection=H.numClipIntersection,ee.vertexAlphas=H.vertexAlphas,ee.vertexTangents=H.vertexTangents,ee.toneMapping=H.toneMapping}function Ho(w,H,ee,J,K){H.isScene!==!0&&(H=xn),Ye.resetTextureUnits();let Ee=H.fog,Le=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?H.environment:null,Ae=j===null?F.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:bt.workingColorSpace,De=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Ve=C.get(J.envMap||Le,De),st=J.vertexColors===!0&&!!ee.attributes.color&&ee.attributes.color.itemSize===4,_t=!!ee.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),ze=!!ee.morphAttributes.position,xt=!!ee.morphAttributes.normal,en=!!ee.morphAttributes.color,Lt=is;J.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(Lt=F.toneMapping);let Dt=ee.morphAttributes.position||ee.morphAttributes.normal||ee.morphAttributes.color,yn=Dt!==void 0?Dt.length:0,Oe=Ge.get(J),fn=E.state.lights;if(Wt===!0&&(hn===!0||w!==Z)){let Nt=w===Z&&J.id===$;re.setState(J,w,Nt)}let St=!1,ds=!1;J.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==fn.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==Ve||J.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==re.numPlanes||Oe.numIntersection!==re.numIntersection)||Oe.vertexAlphas!==st||Oe.vertexTangents!==_t||Oe.morphTargets!==ze||Oe.morphNormals!==xt||Oe.morphColors!==en||Oe.morphTargetsCount!==yn||Oe.numLightProbeGrids!==cn(E.state.lightProbeGridArray)?St=!0:(Oe.outputColorSpace!==Ae||Oe.toneMapping!==Lt)&&(ds=!0):(St=!0,Oe.__version=J.version);let dn=Oe.currentProgram;(St===!0||ds===!0)&&(dn=ds===!0?si(J,H,K,Ae,Lt):Wi(J,H,K),D&&J.isNodeMaterial&&D.onUpdateProgram(J,dn,Oe));let Fr=!1,$i=!1,ps=!1,pt=dn.getUniforms(),rn=Oe.uniforms;if(we.useProgram(dn.program)&&(Fr=!0,$i=!0,ps=!0),J.id!==$&&($=J.id,$i=!0),Fr||Z!==w){we.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),pt.setValue(z,"projectionMatrix",w.projectionMatrix),pt.setValue(z,"viewMatrix",w.matrixWorldInverse);let pn=pt.map.cameraPosition;pn!==void 0&&pn.setValue(z,En.setFromMatrixPosition(w.matrixWorld)),ht.logarithmicDepthBuffer&&pt.setValue(z,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&pt.setValue(z,"isOrthographic",w.isOrthographicCamera===!0),Z!==w&&(Z=w,$i=!0,ps=!0)}if(Oe.needsLights&&(fn.state.sunShadowMap.length>0&&pt.setValue(z,"sunShadowMap",fn.state.sunShadowMap,Ye),fn.state.directionalShadowMap.length>0&&pt.setValue(z,"directionalShadowMap",fn.state.directionalShadowMap,Ye),fn.state.spotShadowMap.length>0&&pt.setValue(z,"spotShadowMap",fn.state.spotShadowMap,Ye),fn.state.pointShadowMap.length>0&&pt.setValue(z,"pointShadowMap",fn.state.pointShadowMap,Ye)),K.isSkinnedMesh){pt.setOptional(z,K,"bindMatrix"),pt.setOptional(z,K,"bindMatrixInverse");let Nt=K.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),pt.setValue(z,"boneTexture",Nt.boneTexture,Ye))}K.isBatchedMesh&&(pt.setOptional(z,K,"batchingTexture"),pt.setValue(z,"batchingTexture",K._matricesTexture,Ye),pt.setOptional(z,K,"batchingIdTexture"),pt.setValue(z,"batchingIdTexture",K._indirectTexture,Ye),pt.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&pt.setValue(z,"batchingColorTexture",K._colorsTexture,Ye));let Xn=ee.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&oe.update(K,ee,dn),($i||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,pt.setValue(z,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&H.environment!==null&&(rn.envMapIntensity.value=H.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=zM()),$i){if(pt.setValue(z,"toneMappingExposure",F.toneMappingExposure),Oe.needsLights&&Nr(rn,ps),Ee&&J.fog===!0&&xe.refreshFogUniforms(rn,Ee),xe.refreshMaterialUniforms(rn,J,Me,Ce,E.state.transmissionRenderTarget[w.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Nt=b,pn=0;for(let Bn of E.state.lightProbeGridArray)Bn.texture!==null&&(Nt.textures[pn]=Bn.texture,Nt.min[pn]=Bn.boundingBox.min,Nt.max[pn]=Bn.boundingBox.max,Nt.resolution[pn]=Bn.resolution,pn++);for(let Bn in Nt)Nt[Bn].length=pn;rn.probesSH.value=Nt.textures,rn.probesMin.value=Nt.min,rn.probesMax.value=Nt.max,rn.probesResolution.value=Nt.resolution}wo.upload(z,Ds(Oe),rn,Ye)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(wo.upload(z,Ds(Oe),rn,Ye),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&pt.setValue(z,"center",K.center),pt.setValue(z,"modelViewMatrix",K.modelViewMatrix),pt.setValue(z,"normalMatrix",K.normalMatrix),pt.setValue(z,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Nt=J.uniformsGroups;for(let pn=0,Bn=Nt.length;pn<Bn;pn++){let Ka=Nt[pn];We.update(Ka,dn),We.bind(Ka,dn)}}return dn}function Nr(w,H){w.ambientLightColor.needsUpdate=H,w.lightProbe.needsUpdate=H,w.sunLights.needsUpdate=H,w.sunLightShadows.needsUpdate=H,w.directionalLights.needsUpdate=H,w.directionalLightShadows.needsUpdate=H,w.pointLights.needsUpdate=H,w.pointLightShadows.needsUpdate=H,w.spotLights.needsUpdate=H,w.spotLightShadows.needsUpdate=H,w.rectAreaLights.needsUpdate=H,w.hemisphereLights.needsUpdate=H}function Ns(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return O},this.getActiveMipmapLevel=function(){return N},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(w,H,ee){let J=Ge.get(w);J.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Ge.get(w.texture).__webglTexture=H,Ge.get(w.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:ee,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,H){let ee=Ge.get(w);ee.__webglFramebuffer=H,ee.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(w,H=0,ee=0){j=w,O=H,N=ee;let J=null,K=!1,Ee=!1;if(w){let Ae=Ge.get(w);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(z.FRAMEBUFFER,Ae.__webglFramebuffer),ne.copy(w.viewport),fe.copy(w.scissor),ue=w.scissorTest,we.viewport(ne),we.scissor(fe),we.setScissorTest(ue),$=-1;return}else if(Ae.__webglFramebuffer===void 0)Ye.setupRenderTarget(w);else if(Ae.__hasExternalTextures)Ye.rebindTextures(w,Ge.get(w.texture).__webglTexture,Ge.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let st=w.depthTexture;if(Ae.__boundDepthTexture!==st){if(st!==null&&Ge.has(st)&&(w.width!==st.image.width||w.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(w)}}let De=w.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ee=!0);let Ve=Ge.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ve[H])?J=Ve[H][ee]:J=Ve[H],K=!0):w.samples>0&&Ye.useMultisampledRTT(w)===!1?J=Ge.get(w).__webglMultisampledFramebuffer:Array.isArray(Ve)?J=Ve[ee]:J=Ve,ne.copy(w.viewport),fe.copy(w.scissor),ue=w.scissorTest}else ne.copy(He).multiplyScalar(Me).floor(),fe.copy(gt).multiplyScalar(Me).floor(),ue=dt;if(ee!==0&&(J=G),we.bindFramebuffer(z.FRAMEBUFFER,J)&&we.drawBuffers(w,J),we.viewport(ne),we.scissor(fe),we.setScissorTest(ue),K){let Ae=Ge.get(w.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Ae.__webglTexture,ee)}else if(Ee){let Ae=H;for(let De=0;De<w.textures.length;De++){let Ve=Ge.get(w.textures[De]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+De,Ve.__webglTexture,ee,Ae)}}else if(w!==null&&ee!==0){let Ae=Ge.get(w.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Ae.__webglTexture,ee)}$=-1};function Ur(w){let H=Ge.get(w);return(H.__readFormat!==w.format||H.__readType!==w.type)&&(H.__readFormat=w.format,H.__readType=w.type,H.__formatReadable=ht.textureFormatReadable(w.format),H.__typeReadable=ht.textureTypeReadable(w.type)),H}this.readRenderTargetPixels=function(w,H,ee,J,K,Ee,Le,Ae=0){if(!(w&&w.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=Ge.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){we.bindFramebuffer(z.FRAMEBUFFER,De);try{let Ve=w.textures[Ae],st=Ve.format,_t=Ve.type;w.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Ae);let ze=Ur(Ve);if(ze.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=w.width-J&&ee>=0&&ee<=w.height-K&&z.readPixels(H,ee,J,K,_e.convert(st),_e.convert(_t),Ee)}finally{let Ve=j!==null?Ge.get(j).__webglFramebuffer:null;we.bindFramebuffer(z.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(w,H,ee,J,K,Ee,Le,Ae=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=Ge.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(H>=0&&H<=w.width-J&&ee>=0&&ee<=w.height-K){we.bindFramebuffer(z.FRAMEBUFFER,De);let Ve=w.textures[Ae],st=Ve.format,_t=Ve.type;w.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Ae);let ze=Ur(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,xt),z.bufferData(z.PIXEL_PACK_BUFFER,Ee.byteLength,z.STREAM_READ),z.readPixels(H,ee,J,K,_e.convert(st),_e.convert(_t),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let en=j!==null?Ge.get(j).__webglFramebuffer:null;we.bindFramebuffer(z.FRAMEBUFFER,en);let Lt=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await im(z,Lt,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,xt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ee),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(xt),z.deleteSync(Lt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,H=null,ee=0){let J=Math.pow(2,-ee),K=Math.floor(w.image.width*J),Ee=Math.floor(w.image.height*J),Le=H!==null?H.x:0,Ae=H!==null?H.y:0;Ye.setTexture2D(w,0),z.copyTexSubImage2D(z.TEXTURE_2D,ee,0,0,Le,Ae,K,Ee),we.unbindTexture()},this.copyTextureToTexture=function(w,H,ee=null,J=null,K=0,Ee=0){let Le,Ae,De,Ve,st,_t,ze,xt,en,Lt=w.isCompressedTexture?w.mipmaps[Ee]:w.image;if(ee!==null)Le=ee.max.x-ee.min.x,Ae=ee.max.y-ee.min.y,De=ee.isBox3?ee.max.z-ee.min.z:1,Ve=ee.min.x,st=ee.min.y,_t=ee.isBox3?ee.min.z:0;else{let pt=Math.pow(2,-K);Le=Math.floor(Lt.width*pt),Ae=Math.floor(Lt.height*pt),w.isDataArrayTexture?De=Lt.depth:w.isData3DTexture?De=Math.floor(Lt.depth*pt):De=1,Ve=0,st=0,_t=0}J!==null?(ze=J.x,xt=J.y,en=J.z):(ze=0,xt=0,en=0);let Dt=_e.convert(H.format),yn=_e.convert(H.type),Oe;H.isData3DTexture?(Ye.setTexture3D(H,0),Oe=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Ye.setTexture2DArray(H,0),Oe=z.TEXTURE_2D_ARRAY):(Ye.setTexture2D(H,0),Oe=z.TEXTURE_2D),we.activeTexture(z.TEXTURE0),we.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),we.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),we.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let fn=we.getParameter(z.UNPACK_ROW_LENGTH),St=we.getParameter(z.UNPACK_IMAGE_HEIGHT),ds=we.getParameter(z.UNPACK_SKIP_PIXELS),dn=we.getParameter(z.UNPACK_SKIP_ROWS),Fr=we.getParameter(z.UNPACK_SKIP_IMAGES);we.pixelStorei(z.UNPACK_ROW_LENGTH,Lt.width),we.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Lt.height),we.pixelStorei(z.UNPACK_SKIP_PIXELS,Ve),we.pixelStorei(z.UNPACK_SKIP_ROWS,st),we.pixelStorei(z.UNPACK_SKIP_IMAGES,_t);let $i=w.isDataArrayTexture||w.isData3DTexture,ps=H.isDataArrayTexture||H.isData3DTexture;if(w.isDepthTexture){let pt=Ge.get(w),rn=Ge.get(H),Xn=Ge.get(pt.__renderTarget),Nt=Ge.get(rn.__renderTarget);we.bindFramebuffer(z.READ_FRAMEBUFFER,Xn.__webglFramebuffer),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let pn=0;pn<De;pn++)$i&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ge.get(w).__webglTexture,K,_t+pn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ge.get(H).__webglTexture,Ee,en+pn)),z.blitFramebuffer(Ve,st,Ve+Le,st+Ae,ze,xt,ze+Le,xt+Ae,z.DEPTH_BUFFER_BIT,z.NEAREST);we.bindFramebuffer(z.READ_FRAMEBUFFER,null),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||w.isRenderTargetTexture||Ge.has(w)){let pt=Ge.get(w),rn=Ge.get(H);we.bindFramebuffer(z.READ_FRAMEBUFFER,P),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,W);for(let Xn=0;Xn<De;Xn++)$i?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,pt.__webglTexture,K,_t+Xn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,pt.__webglTexture,K),ps?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,rn.__webglTexture,Ee,en+Xn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,rn.__webglTexture,Ee),K!==0?z.blitFramebuffer(Ve,st,Ve+Le,st+Ae,ze,xt,ze+Le,xt+Ae,z.COLOR_BUFFER_BIT,z.NEAREST):ps?z.copyTexSubImage3D(Oe,Ee,ze,xt,en+Xn,Ve,st,Le,Ae):z.copyTexSubImage2D(Oe,Ee,ze,xt,Ve,st,Le,Ae);we.bindFramebuffer(z.READ_FRAMEBUFFER,null),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else ps?w.isDataTexture||w.isData3DTexture?z.texSubImage3D(Oe,Ee,ze,xt,en,Le,Ae,De,Dt,yn,Lt.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Oe,Ee,ze,xt,en,Le,Ae,De,Dt,Lt.data):z.texSubImage3D(Oe,Ee,ze,xt,en,Le,Ae,De,Dt,yn,Lt):w.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ee,ze,xt,Le,Ae,Dt,yn,Lt.data):w.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ee,ze,xt,Lt.width,Lt.height,Dt,Lt.data):z.texSubImage2D(z.TEXTURE_2D,Ee,ze,xt,Le,Ae,Dt,yn,Lt);we.pixelStorei(z.UNPACK_ROW_LENGTH,fn),we.pixelStorei(z.UNPACK_IMAGE_HEIGHT,St),we.pixelStorei(z.UNPACK_SKIP_PIXELS,ds),we.pixelStorei(z.UNPACK_SKIP_ROWS,dn),we.pixelStorei(z.UNPACK_SKIP_IMAGES,Fr),Ee===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Oe),we.unbindTexture()},this.initRenderTarget=function(w){Ge.get(w).__webglFramebuffer===void 0&&Ye.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Ye.setTextureCube(w,0):w.isData3DTexture?Ye.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Ye.setTexture2DArray(w,0):Ye.setTexture2D(w,0),we.unbindTexture()},this.resetState=function(){O=0,N=0,j=null,we.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Si}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var $m=new Y(0,1,0),Hm=[[1,0,0],[0,1,0],[0,0,1]],VM=70,Wm=n=>new Y(n[3],n[7],n[11]);function GM(n,e,t){let i=t.clone().sub(e),s=i.length();n.visible=s>1,n.visible&&(n.position.copy(e).addScaledVector(i,.5),n.quaternion.copy(new Vn().setFromUnitVectors($m,i.normalize())),n.scale.set(1,s,1))}var Mr=class{constructor(e,{thickness:t,transparent:i,opacity:s,axes:r}){this.arm=e,this.material=new go({transparent:i,opacity:s,depthWrite:!i}),this.jointMaterial=new go({transparent:i,opacity:s,depthWrite:!i}),this.group=new Di;let o=e.joints.length,a=new mo(t,t,1,20),l=new mo(t*1.45,t*1.45,t*3.2,24),c=new Zs(t*2.4,t*5,t*2.4),u=new ga(t,20,14),f=(h,d)=>{let p=new bi(h,d);return this.group.add(p),p};if(this.bars=Array.from({length:o+2},()=>f(a,this.material)),this.bars[o+1].scale.setScalar(.4),this.knees=Array.from({length:o+1},()=>f(u,this.material)),this.hubs=e.joints.map(h=>f(h.slides?c:l,this.jointMaterial)),r){let h=Hm.flatMap(p=>[...p,...p].map(y=>.25+.6*y)),d=new vn;d.setAttribute("position",new Bt(new Float32Array((o+1)*18),3)),d.setAttribute("color",new Bt(Array.from({length:o+1},()=>h).flat(),3)),this.lines=new Ys(d,new es({vertexColors:!0,depthTest:!1})),this.lines.frustumCulled=!1,this.group.add(this.lines)}}paint(e,t){this.material.color.set(e),this.jointMaterial.color.set(t)}pose(e,t,i={},s=1){let r=Hd(this.arm,e,i,s),o=this.arm.joints.length,a=qh(r[o],t),l=[Wm(Xh()),...r.map(Wm),new Y(...a)];return this.bars.forEach((c,u)=>GM(c,l[u],l[u+1])),this.bars[o+1].scale.x=.35,this.bars[o+1].scale.z=.35,this.knees.forEach((c,u)=>c.position.copy(l[u+1])),this.hubs.forEach((c,u)=>{let f=r[u],[h,d,p]=this.arm.joints[u].axis,y=new Y(f[0]*h+f[1]*d+f[2]*p,f[4]*h+f[5]*d+f[6]*p,f[8]*h+f[9]*d+f[10]*p);c.position.copy(l[u+1]),c.quaternion.copy(new Vn().setFromUnitVectors($m,y))}),this.lines&&this.drawAxes(r),a}drawAxes(e){let{position:t}=this.lines.geometry.attributes;e.forEach((i,s)=>{Hm.forEach((r,o)=>{let a=qh(i,r.map(l=>l*VM));t.setXYZ(s*6+o*2,i[3],i[7],i[11]),t.setXYZ(s*6+o*2+1,...a)})}),t.needsUpdate=!0}};var ah=document.documentElement,Xm=matchMedia("(prefers-color-scheme: dark)"),qm=new Set,HM=()=>ah.dataset.theme?ah.dataset.theme==="dark":Xm.matches,oh=new Map;function Vt(n){return oh.has(n)||oh.set(n,getComputedStyle(ah).getPropertyValue(`--${n}`).trim()),oh.get(n)}var os=n=>qm.add(n);function Ym(){oh.clear(),qm.forEach(n=>n())}function vf(n){ah.dataset.theme=n==="dark"?"dark":"light",Ym()}var Zm=()=>vf(HM()?"light":"dark");Xm.addEventListener("change",Ym);function jm(n=["scale-0","scale-1","scale-2"].map(Vt)){let e=n.map(t=>[1,3,5].map(i=>parseInt(t.slice(i,i+2),16)/255));return(t,i,s)=>{let r=Math.min(Math.max(t,0),1)*(e.length-1),o=Math.min(Math.floor(r),e.length-2);for(let a=0;a<3;a+=1)i[s+a]=e[o][a]+(e[o+1][a]-e[o][a])*(r-o)}}var Jm=.28,WM=1500,$M=4e3;function XM(){let n=B("canvas",{width:64,height:64}),e=n.getContext("2d");return e.fillStyle="#fff",e.beginPath(),e.arc(32,32,30,0,2*Math.PI),e.fill(),new fa(n)}var lh=n=>new Bt(new Float32Array(n),3),Eo=class{constructor(e){this.places=e,this.count=e.length/3,this.group=new Di;let t=XM(),i=this.count>$M?{size:3}:{size:this.count>2e3?5:9,map:t,alphaTest:.5};this.geometry=new vn,this.geometry.setAttribute("position",new Bt(e,3)),this.geometry.setAttribute("color",lh(3*this.count)),this.dots=new po(this.geometry,new _r({vertexColors:!0,sizeAttenuation:!1,...i})),this.path=new fo(this.geometry,new es({transparent:this.count<=2e3,opacity:.55})),this.step=Math.max(Math.ceil(this.count/WM),1);let s=Math.ceil(this.count/this.step);this.arrows=new Ys(new vn,new es({vertexColors:!0})),this.arrows.geometry.setAttribute("position",lh(18*s)),this.arrows.geometry.setAttribute("color",lh(18*s)),this.ring=new po(new vn,new _r({size:17,map:t,alphaTest:.5,sizeAttenuation:!1,depthTest:!1,transparent:!0,opacity:.45})),this.ring.geometry.setAttribute("position",lh(3)),this.ring.visible=!1;for(let r of[this.path,this.arrows,this.ring,this.dots])r.frustumCulled=!1,this.group.add(r)}paint({path:e,ring:t}){this.path.material.color.set(e),this.ring.material.color.set(t)}mark(e){this.ring.visible=e!==null,e!==null&&(this.ring.geometry.attributes.position.setXYZ(0,...this.places.slice(3*e,3*e+3)),this.ring.geometry.attributes.position.needsUpdate=!0)}show(e,t,i){let s=this.geometry.attributes.color.array,r=this.arrows.geometry.attributes.position.array,o=this.arrows.geometry.attributes.color.array,a=jm(),l=[0,0,0];for(let c=0;c<this.count;c+=1){if(e(c,l),a(Math.hypot(l[0],l[1],l[2])/i,s,3*c),c%this.step!==0)continue;let u=18*(c/this.step);this.arrow(r,u,3*c,l,t);for(let f=0;f<18;f+=1)o[u+f]=s[3*c+f%3]}this.geometry.attributes.color.needsUpdate=!0,this.arrows.geometry.attributes.position.needsUpdate=!0,this.arrows.geometry.attributes.color.needsUpdate=!0}arrow(e,t,i,[s,r,o],a){let l=this.places,c=[l[i]+s*a,l[i+1]+r*a,l[i+2]+o*a],u=Math.abs(o)>Math.hypot(s,r)?[o,0,-s]:[-r,s,0];for(let f=0;f<3;f+=1){let h=[s,r,o][f]*a*Jm,d=u[f]*a*Jm*.5;e[t+f]=l[i+f],e[t+3+f]=c[f],e[t+6+f]=c[f],e[t+9+f]=c[f]-h+d,e[t+12+f]=c[f],e[t+15+f]=c[f]-h-d}}};var Km={type:"change"},bf={type:"start"},eg={type:"end"},ch=new Ts,Qm=new ui,qM=Math.cos(70*Qu.DEG2RAD),Mn=new Y,ii=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Sf=1e-6,hh=class extends Ta{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new Y,this.cursor=new Y,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Qs.ROTATE,MIDDLE:Qs.DOLLY,RIGHT:Qs.PAN},this.touches={ONE:er.ROTATE,TWO:er.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Y,this._lastQuaternion=new Vn,this._lastTargetPosition=new Y,this._quat=new Vn().setFromUnitVectors(e.up,new Y(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new xo,this._sphericalDelta=new xo,this._scale=1,this._panOffset=new Y,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new Y,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=ZM.bind(this),this._onPointerDown=YM.bind(this),this._onPointerUp=jM.bind(this),this._onContextMenu=iw.bind(this),this._onMouseWheel=QM.bind(this),this._onKeyDown=ew.bind(this),this._onTouchStart=tw.bind(this),this._onTouchMove=nw.bind(this),this._onMouseDown=JM.bind(this),this._onMouseMove=KM.bind(this),this._interceptControlDown=sw.bind(this),this._interceptControlUp=rw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Km),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ii:i>Math.PI&&(i-=ii),s<-Math.PI?s+=ii:s>Math.PI&&(s-=ii),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Y(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Y(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ch.origin.copy(this.object.position),ch.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ch.direction))<qM?this.object.lookAt(this.target):(Qm.setFromNormalAndCoplanarPoint(this.object.up,this.target),ch.intersectPlane(Qm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Sf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Sf||this._lastTargetPosition.distanceToSquared(this.target)>Sf?(this.dispatchEvent(Km),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ii/60*this.autoRotateSpeed*e:ii/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/t.clientHeight),this._rotateUp(ii*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/t.clientHeight),this._rotateUp(ii*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function YM(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function ZM(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function jM(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(eg),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function JM(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ct.DOLLY;break;case Qs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}break;case Qs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(bf)}function KM(n){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function QM(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(n.preventDefault(),this.dispatchEvent(bf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(eg))}function ew(n){this.enabled!==!1&&this._handleKeyDown(n)}function tw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case er.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(n),this.state=Ct.TOUCH_ROTATE;break;case er.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(n),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case er.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ct.TOUCH_DOLLY_PAN;break;case er.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(bf)}function nw(n){switch(this._trackPointer(n),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ct.NONE}}function iw(n){this.enabled!==!1&&n.preventDefault()}function sw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function rw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ow=2e3,Mf=class{constructor(e,t){this.canvas=B("canvas",{tabIndex:0,role:"img","aria-label":e}),this.element=B("div",{class:"view3d"},this.canvas),this.renderer=new ih({canvas:this.canvas,antialias:!t,preserveDrawingBuffer:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,t?1:2)),this.scene=new la,this.camera=new jn(35,1,10,6e4),this.camera.up.set(0,0,1),this.sky=new ya(16777215,6710886,2.2),this.sky.position.set(0,0,1),this.sun=new ba(16777215,1.6),this.sun.position.set(1500,-2500,4e3),this.scene.add(this.sky,this.sun),this.controls=new hh(this.camera,this.canvas),this.controls.listenToKeyEvents(this.canvas),this.controls.addEventListener("change",()=>this.redraw()),this.canvas.addEventListener("keydown",i=>this.zoomByKey(i)),this.pending=new Set,this.redraw=Yo(()=>this.draw()),this.themed=[],os(()=>this.dress()),new ResizeObserver(()=>this.resize()).observe(this.element),this.dress()}dressed(e){this.themed.push(e),e(),this.redraw()}dress(){this.scene.background=new ut(Vt("stage")),this.floor&&this.scene.remove(this.floor),this.floor=new wa(ow,20,Vt("grid-strong"),Vt("grid")),this.floor.rotation.x=Math.PI/2,this.scene.add(this.floor),this.themed.forEach(e=>e()),this.redraw()}lookAt(e,t){let i=new Y((e[0]+t[0])/2,(e[1]+t[1])/2,(e[2]+t[2])/2);this.radius=Math.max(Math.hypot(t[0]-e[0],t[1]-e[1],t[2]-e[2])/2,50),this.centre=i,this.home()}home(){let{aspect:e}=this.camera,t=this.camera.fov*Math.PI/360,i=this.radius/Math.sin(t)*(e<1?1/e:1)*.82;this.controls.target.copy(this.centre),this.camera.position.copy(this.centre).add(new Y(.72,-.95,.5).normalize().multiplyScalar(i)),this.controls.update(),this.redraw()}zoomByKey(e){let t={"+":.87,"=":.87,"-":1.15}[e.key];e.key==="Home"&&this.home(),t&&(this.camera.position.sub(this.controls.target).multiplyScalar(t).add(this.controls.target),this.controls.update(),e.preventDefault())}resize(){let{clientWidth:e,clientHeight:t}=this.element;if(e===0||t===0)return;let i=this.camera.aspect===1;this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),i&&this.centre&&this.home(),this.draw()}beforePicture(e){return()=>{this.pending.add(e),this.redraw()}}draw(){this.pending.forEach(e=>e()),this.pending.clear(),this.renderer.render(this.scene,this.camera)}onPick(e,t){let i=null;this.canvas.addEventListener("pointerdown",s=>{i=[s.clientX,s.clientY]}),this.canvas.addEventListener("pointerup",s=>{if(!i||Math.hypot(s.clientX-i[0],s.clientY-i[1])>4)return;let r=this.canvas.getBoundingClientRect(),o=new Ke((s.clientX-r.left)/r.width*2-1,1-(s.clientY-r.top)/r.height*2),a=new Ma,l=this.camera.position.distanceTo(this.controls.target);a.params.Points.threshold=9/r.height*2*l*Math.tan(this.camera.fov*Math.PI/360),a.setFromCamera(o,this.camera);let[c]=a.intersectObject(e()).sort((u,f)=>u.distanceToRay-f.distanceToRay);c&&t(c.index)})}toWindow([e,t,i]){let s=new Y(e,t,i).project(this.camera),r=this.canvas.getBoundingClientRect();return[r.left+(s.x+1)/2*r.width,r.top+(1-s.y)/2*r.height]}};function uh(n,e=!1){try{return new Mf(n,e)}catch{return null}}function Ao({label:n,min:e,max:t,step:i,value:s,show:r,on:o,name:a}){let l=hr("slider"),c=B("output",{htmlFor:l}),u=B("input",{type:"range",id:l,min:e,max:t,step:i,name:a??l,oninput:()=>f(!0)}),f=h=>{let d=r(Number(u.value));c.textContent=d,u.setAttribute("aria-valuetext",d),h&&o(Number(u.value))};return u.value=s,f(!1),{element:B("div",{class:"slider"},B("label",{htmlFor:l,text:n}),c,u),input:u,set(h){Number(u.value)!==h&&(u.value=h,f(!1))},refresh:()=>f(!1)}}function Ba({label:n,value:e,on:t,name:i}){let s=hr("check"),r=B("input",{type:"checkbox",id:s,checked:e,name:i??s,onchange:()=>t(r.checked)});return B("div",{class:"check"},r,B("label",{htmlFor:s,text:n}))}function fh({label:n,options:e,value:t,on:i,name:s}){let r=hr("choice"),o=([a,l])=>{let c=hr("option"),u=B("input",{type:"radio",id:c,name:r,value:a,checked:a===t,onchange:()=>i(a)});return B("span",{class:"option"},u,B("label",{htmlFor:c,text:l}))};return B("fieldset",{class:"choice","data-name":s??r},B("legend",{text:n}),e.map(o))}function tg({label:n,options:e,value:t,on:i,name:s}){let r=hr("select"),o=B("select",{id:r,name:s??r,onchange:()=>i(o.value)},e.map(([a,l])=>B("option",{value:a,text:l})));return o.value=t,B("div",{class:"field"},B("label",{htmlFor:r,text:n}),o)}function ka({label:n,on:e,name:t,type:i="search",placeholder:s=""}){let r=hr("search"),o=B("input",{type:i,id:r,placeholder:s,name:t??r,autocomplete:"off",spellcheck:!1,oninput:()=>e(o.value)});return B("div",{class:"field"},B("label",{htmlFor:r,text:n}),o)}var Mi=(n,e,t={})=>B("button",{type:"button",text:n,onclick:e,...t});function ig({title:n,kind:e,verdict:t,tone:i,version:s,tasks:r,which:o}){let a=B("nav",{"aria-label":"Sections"});return{element:B("header",{class:"top"},B("div",{class:"brand"},B("p",{class:"kind"},B("span",{class:"word",text:"driftpost"}),` ${s} \xB7 ${e}`),B("h1",{title:n,text:n}),r&&B("p",{class:"tasks"},r.map((c,u)=>B("a",{href:`?task=${u+1}`,text:c,"aria-current":u===o&&"page"}))),t&&B("p",{class:`verdict ${i}`,text:t})),B("div",{class:"tools"},Mi("Light / dark",Zm,{class:"small",name:"theme"}),Mi("Print",()=>print(),{class:"small"})),a),link:c=>a.append(B("a",{href:`#${c.id}`,text:c.dataset.short}))}}function Ze(n,e,t,...i){return B("section",{id:n,"aria-labelledby":`${n}-title`,"data-short":t},B("h2",{id:`${n}-title`,text:e}),...i)}var Qe=(n,e,t,i,s="")=>B("div",{class:`figure ${s}`},B("dt",{text:n}),B("dd",{},B("span",{class:"value",text:e}),t&&e!==Ot&&B("span",{class:"unit",text:` ${t}`}),i&&B("span",{class:"note",text:i}))),Hn=(...n)=>B("dl",{class:"figures"},n),ng=8,dh=12,wr=n=>n.split("/").pop();function ei(n,e){let t=r=>B("li",{class:`message ${e}`},B("span",{class:"code",text:r.code}),B("span",{class:"said",text:r.message}),r.file&&B("span",{class:"place",title:r.file,text:`${wr(r.file)}${r.line?`:${r.line}`:""}`}),r.help&&B("span",{class:"help",text:r.help})),i=n.slice(0,ng).map(t),s=n.slice(ng);return[B("ul",{class:"messages"},i),s.length>0&&as(`${qe(s.length,"more message")}`,()=>B("ul",{class:"messages"},s.slice(0,500).map(t),s.length>500&&B("li",{class:"message",text:`and ${s.length-500} more: see the JSON`})),{printed:!0})]}function ki(n){let e=t=>B("ul",{class:"notes"},t.map(i=>B("li",{text:i})));return!n||n.length===0?null:[e(n.slice(0,dh)),n.length>dh&&as(qe(n.length-dh,"more sentence"),()=>e(n.slice(dh)),{printed:!0})]}function as(n,e,{printed:t=!1}={}){let i=B("details",{},B("summary",{text:n})),s=()=>{i.children.length===1&&i.append(...[e()].flat())};if(i.addEventListener("toggle",()=>{i.open&&s()}),t){let r=!1;addEventListener("beforeprint",()=>{r=i.open,s(),i.open=!0}),addEventListener("afterprint",()=>{i.open=r})}return i}var wi=n=>n.text&&as("The report as printed",()=>B("pre",{class:"report",tabIndex:0,text:n.text})),wf=n=>B("dl",{class:"facts"},n.map(([e,t])=>B("div",{},B("dt",{text:e}),B("dd",{text:t}))));function Wn(n,e){let t=i=>B("div",{class:"sign"},B("span",{class:"line"}),B("span",{text:`${i}: name, date, signature`}));return Ze("record","Record","Record",wf([...n,["made with",`driftpost ${e}`]]),B("div",{class:"signatures"},t("Made by"),t("Reviewed by"),t("Released by")))}var Tr=400;function ph(n,e,t){let i=Math.min(n,Tr);if(i===e)return qe(e,t);let s=[n<e&&"that match the search",n>Tr&&`the first ${Ie(Tr)} in this order`].filter(Boolean);return`Printed: ${Ie(i)} of ${qe(e,t)}, ${s.join(", ")}.`}var Tf=40;function aw(n){let{shared:e,files:t}=n.source;return t.flatMap(i=>i.rows.map(([s,r,o,a,l])=>({file:i.path,line:s,start:e[r],old:o,now:Array.isArray(a)?a.join(o):a,end:e[l]})))}function Ef(n,e){return n.lines||(n.lines=n.view.source?aw(n.view):[],n.lineAt=new Map(n.lines.map(t=>[`${t.file}:${t.line}`,t]))),n.lineAt.get(`${e.file}:${e.line}`)??null}var sg=(n,e,t)=>B("code",{},n.start.trimStart(),e!==""&&B(t,{text:e}),n.end),rg=n=>n.now===null?B("code",{text:(n.start+n.old+n.end).trimStart()}):sg(n,n.old,"del"),og=n=>n.now===null?B("code",{class:"same",text:"stays as it is"}):sg(n,n.now,"ins");function ag(n){return n?B("div",{class:"pair"},B("div",{class:"side"},rg(n)),B("div",{class:"side"},og(n))):B("p",{class:"calm",text:"its line is not on this page"})}function lg(n){let{view:e,data:t,course:i,correction:s}=n;Ef(n,{});let r=new Map(t.motions.map(D=>[`${D.file}:${D.line}`,D])),o=new Map(i?i.points.motion.map((D,G)=>[D,G]):[]),a={text:"",bucket:"",least:0},l=0,c=[],u=B("div",{class:"diff-rows"}),f=B("p",{class:"status",role:"status"}),h=Mi("Previous",()=>E(-1),{class:"small"}),d=Mi("Next",()=>E(1),{class:"small"}),p=D=>r.get(`${D.file}:${D.line}`);function y(D){if(!D||D.status!=="compensated")return null;let G=o.get(D.index);if(a.bucket===""||G===void 0)return{size:D.max_correction_mm};let P=i.error(G,s.buckets[Number(a.bucket)].shares).map(W=>-W);return{size:yi(P),by:P}}let g=(D,G)=>(D.text??=`${D.file}:${D.line} ${D.start}${D.old}${D.end} ${D.now??""} ${G?.target??""} ${G?.routine??""}`.toLowerCase(),D.text);function m(){let D=a.text.trim().toLowerCase();c=n.lines.filter(G=>{let P=p(G);return a.least>0&&!((y(P)?.size??0)>=a.least)?!1:D?g(G,P).includes(D):!0}),l=0,v()}function v(){let D=Math.max(Math.ceil(c.length/Tf),1),G=c.slice(l*Tf,(l+1)*Tf);A(G);let P=n.lines.length,W=c.length===P?qe(P,"line"):`${Ie(c.length)} of ${qe(P,"line")}`;f.textContent=D>1?`${W}, page ${Ie(l+1)} of ${Ie(D)}`:W,h.disabled=l===0,d.disabled=l>=D-1,V.hidden=D<2}function A(D){let G=null;u.replaceChildren(...D.flatMap(P=>{let W=P.file===G?[]:[B("p",{class:"diff-file"},B("span",{text:P.file}),R(P.file))];G=P.file;let O=y(p(P)),N=O?B("span",{class:"size",text:O.by?`${O.by.map(j=>de(j)).join(", ")} mm`:`${de(O.size)} mm`}):null;return[...W,B("div",{class:P.now===null?"diff-row same":"diff-row"},B("span",{class:"line",text:P.line}),B("div",{class:"side old"},rg(P)),B("div",{class:"side new"},og(P),N))]})),D.length===0&&u.append(B("p",{class:"empty",text:"no line matches"}))}let b=new Map(e.source.files.map(D=>[D.path,D.result])),R=D=>b.get(D)?B("span",{class:"result",text:` \u2192 ${b.get(D)}`}):null;function E(D){l+=D,v()}let _=D=>{Object.assign(a,D),m()},T=D=>`${D.index}: ${D.from_min} to ${D.to_min??"\u221E"} min`,V=B("div",{class:"pager"},h,d),F=B("div",{class:"bar"},ka({label:"Motion, routine or text",name:"source-search",on:D=>_({text:D})}),i&&s.inBuckets&&tg({label:"Correction of bucket",name:"source-bucket",value:"",options:[["","largest of all"],...s.buckets.map((D,G)=>[String(G),T(D)])],on:D=>_({bucket:D})}),ka({label:"At least, mm",name:"source-least",type:"number",on:D=>_({least:Number(D)||0})}),f,V);addEventListener("beforeprint",()=>{A(c.slice(0,Tr)),f.textContent=ph(c.length,n.lines.length,"line")}),addEventListener("afterprint",v),m(),il(n.lines.length,D=>g(n.lines[D],p(n.lines[D])));let L=e.source.files.reduce((D,G)=>D+G.left_out,0);return Ze("source","Source, line by line","Source",F,B("div",{class:"diff",tabIndex:0,role:"group","aria-label":"Source before and after"},u),L>0&&B("p",{class:"notice",text:`${qe(L,"more changed line")} are not on this page; --diff FILE writes all.`}),lw(e.source.files))}function lw(n){let e=n.flatMap(i=>i.added.map(s=>({path:i.result??i.path,...s})));if(e.length===0)return null;let t=e.reduce((i,s)=>i+s.lines,0);return as(`${qe(t,"line")} added in ${qe(e.length,"place")}: comment block, data and routines whose names begin with tc`,()=>B("div",{},e.slice(0,60).map(i=>B("div",{class:"added"},B("p",{class:"diff-file",text:`${i.path}, after line ${i.after} of the source: ${qe(i.lines,"line")}`}),B("pre",{tabIndex:0,text:i.text.join(`
`)+(i.lines>i.text.length?`
\u2026 ${qe(i.lines-i.text.length,"more line")}`:"")})))))}var mh=(n,e=4)=>n.map(t=>de(t,e)).join(", ");function cg(n){let{course:e,correction:t,state:i,motions:s}=n,r=B("div",{class:"card-body"}),o=B("div",{class:"card","aria-live":"polite",id:"target"},B("h3",{text:"Target"}),r),a=()=>{let l=i.point;if(l===null)return r.replaceChildren(B("p",{class:"calm",text:"Click on a target, or choose one in the table of motions."}));let c=s.get(e.points.motion[l]),u=c?Af(c,e.points.value[l]):`target ${l+1}`;o.querySelector("h3").textContent=`Target ${u}`;let f=e.at(i.t),h=e.error(l,f),d=e.error(l,t.leftShares(i.t)),p=e.error(l,t.correctedShares(i.t)).map(v=>-v),y=(v,A,b)=>B("div",{},B("dt",{text:v}),B("dd",{text:A},b&&B("span",{class:"note",text:b}))),g=t.bucketAt(i.t),m=c?.status==="compensated";r.replaceChildren(B("dl",{class:"numbers"},y("in the base",`${mh(e.position(l),3)} mm`),y("joints",`${e.joints(l).map(v=>nl(v,2)).join(", ")}\xB0`),y("at",`${rt(e.from+i.t)} ${e.unit}${g?`, bucket ${g.index}`:""}`),y("uncorrected",`${de(yi(h))} mm`,mh(h)),m&&y("corrected",t.inBuckets?`${de(yi(d))} mm`:`\u2264 ${de(c.after_mm)} mm`,t.inBuckets?mh(d):"at any minute"),m&&y("correction",`${de(yi(p))} mm`,mh(p)),c&&y("worst of all minutes",`${de(c.before_mm)} mm`,m?`${de(c.after_mm)} mm corrected`:c.status)),c&&B("p",{class:"where"},`${c.file}:${c.line}`,c.routine&&` in ${c.routine}`),c&&ag(Ef(n,c)))};return i.on("t point",a),a(),o}function Af(n,e=0){let t=n.target??`line ${n.line}`;return e>0?`${t} (value ${e+1})`:t}var hg=16,fg=500,Cf=200,cw=4e3,ug=n=>Math.round(fg**(n/Cf)),hw=n=>Math.round(Math.log(n)/Math.log(fg)*Cf);function dg(n){let{course:e,state:t,view:i}=n,s=ol(i.robot),r=`${i.robot.name}: the arm, its drift enlarged`,o=uh(`The arm in 3-D with ${e.count} targets. Arrow keys with Shift turn it, plus and minus zoom, Home looks from the start again.`,e.count>cw),a=cg(n),l=B("div",{class:"panel"},dw(n),pw(n),mw(n),gw(n,s));if(!o)return Ze("arm",r,"Arm",B("p",{class:"notice",text:"This browser draws no 3-D (WebGL is off)."}),B("div",{class:"stage"},l),a);let c=new Mr(s,{thickness:30,transparent:!0,opacity:.32,axes:!1}),u=new Mr(s,{thickness:24,transparent:!1,opacity:1,axes:!0}),f=new Eo(e.points.p_mm);o.scene.add(c.group,u.group,f.group),o.dressed(()=>{c.paint(Vt("nominal"),Vt("nominal")),u.paint(Vt("arm"),Vt("arm-joint")),f.paint({path:Vt("path"),ring:Vt("accent")})});let h=Math.max(n.data.worst_before_mm||_w(e),1e-6),d=new Float64Array(3),p=!0,y=o.beforePicture(()=>{let{t:A,times:b,corrected:R,point:E}=t;if(p){let _=R?n.correction.leftShares(A):e.at(A);f.show((T,V)=>e.error(T,_,V),b,h),p=!1}f.arrows.visible=t.arrows!==!1,f.path.visible=t.path!==!1,f.mark(E),m()}),g=B("p",{class:"hud",role:"status"});function m(){let A=t.joints??e.joints(0),b=e.tool(t.point??0),R=e.deviation(t.point??0,t.t),E=c.pose(A,b),_=u.pose(A,b,R);u.pose(A,b,R,t.times);let T=Math.hypot(..._.map((L,D)=>L-E[D])),V=e.isByTarget&&A.some((L,D)=>L!==e.joints(t.point??0)[D]),F=e.hasModel&&!e.model?"":`, off by ${de(T)} mm${V?" with the deformation at the target":""}`;g.textContent=`TCP ${E.map(L=>L.toFixed(1)).join(", ")} mm${F}`}let v=()=>{p=!0,y()};return t.on("t times corrected",v),t.on("point arrows path joints",y),os(v),t.on("point",()=>{t.point!==null&&t.set({joints:e.joints(t.point)})}),o.onPick(()=>f.dots,A=>t.set({point:A})),fw(o,e),y(),o.canvas.windowPlace=A=>o.toWindow(e.position(A)),Ze("arm",r,"Arm",B("div",{class:"stage"},B("div",{class:"screen"},o.element,g,xw(h,t)),l),uw(e),a)}function uw(n){if(!n.hasModel)return null;let e=n.model?n.isByTarget?"The arm is drawn with the deformation table and all that the identified model adds at the chosen target and minute: load, direction and joints of that target included. Jogged away from it, it keeps that deformation: what the model would give there is not on the page.":"The arm is drawn with the deformation table and all that the identified model adds at the minute; it is the same wherever the arm stands.":"Errors at the targets hold all that the identified model adds. Of so many targets the page holds no deformation for each: the arm is drawn with the offsets of the deformation table alone.";return B("p",{class:"notice","data-name":"model-notice",text:e})}function fw(n,e){let t=[-250,-250,0],i=[250,250,700];for(let s=0;s<e.count;s+=1)e.position(s).forEach((r,o)=>{t[o]=Math.min(t[o],r),i[o]=Math.max(i[o],r)});n.lookAt(t,i)}function dw({course:n,state:e}){let t=n.end>20?1:n.end/100,i=Ao({label:n.byTemperature?"Temperature":"Warm-up minute",name:"minute",min:0,max:n.end,step:t,value:e.t,show:c=>`${rt(n.from+c)} ${n.unit}`,on:c=>e.set({t:c})});e.on("t",()=>i.set(e.t));let s=null,r=Mi("Play",()=>s===null?a():o(),{name:"play",class:"small"}),o=()=>{s=null,r.textContent="Play"};function a(){let c=e.t>=n.end?0:e.t;s=performance.now()-c/n.end*hg*1e3,r.textContent="Pause",requestAnimationFrame(l)}function l(c){if(s===null)return;let u=(c-s)/(hg*1e3)*n.end;e.set({t:Math.min(t===1?Math.round(u):u,n.end)}),u>=n.end?o():requestAnimationFrame(l)}return B("div",{class:"row"},i.element,r)}function pw({state:n}){return Ao({label:"Deformation enlarged",name:"times",min:0,max:Cf,step:1,value:hw(n.times),show:e=>`${ug(e)} \xD7`,on:e=>n.set({times:ug(e)})}).element}function mw({state:n}){return B("div",{class:"shows"},fh({label:"Errors",name:"corrected",options:[["no","uncorrected"],["yes","corrected"]],value:"no",on:e=>n.set({corrected:e==="yes"})}),B("div",{class:"checks"},Ba({label:"arrows",name:"arrows",value:!0,on:e=>n.set({arrows:e})}),Ba({label:"path",name:"path",value:!0,on:e=>n.set({path:e})})))}function gw({course:n,state:e},t){let i=t.joints.map((s,r)=>{let[o,a]=s.range??[-360,360];return Ao({label:`J${r+1}`,name:`joint-${r+1}`,min:o,max:a,step:.1,value:(e.joints??n.joints(0))[r],show:l=>`${nl(l,1)}\xB0`,on:l=>{let c=[...e.joints??n.joints(0)];c[r]=l,e.set({joints:c})}})});return e.on("joints",()=>i.forEach((s,r)=>s.set(e.joints[r]))),B("fieldset",{class:"jog"},B("legend",{text:"Jog"}),i.map(s=>s.element),Mi("Back to the target",()=>e.set({joints:n.joints(e.point??0)}),{class:"small"}))}function _w(n){let e=n.at(n.end);return Array.from({length:n.count},(t,i)=>Math.hypot(...n.error(i,e))).reduce((t,i)=>Math.max(t,i),0)}function xw(n,e){let t=B("span",{text:`${de(n,3)} mm`});return B("p",{class:"scale"},B("span",{text:"0"}),B("span",{class:"ramp","aria-hidden":"true"}),t)}var yw="uplot",vw="u-hz",Sw="u-vt",bw="u-title",Mw="u-wrap",ww="u-under",Tw="u-over",Ew="u-axis",Cr="u-off",Aw="u-select",Cw="u-cursor-x",Rw="u-cursor-y",Pw="u-cursor-pt",Iw="u-legend",Lw="u-live",Dw="u-inline",Nw="u-series",Uw="u-marker",pg="u-label",Fw="u-value",Va="width",Ga="height";var mg="bottom",Co="left",Rf="right",Xf="#000",gg=Xf+"0",Pf="mousemove",_g="mousedown",If="mouseup",xg="mouseenter",yg="mouseleave",vg="dblclick",Ow="resize",Bw="scroll",Sg="change",vh="dppxchange",qf="--",Uo=typeof window<"u",Ff=Uo?document:null,Po=Uo?window:null,kw=Uo?navigator:null,Rt,gh;function Of(){let n=devicePixelRatio;Rt!=n&&(Rt=n,gh&&kf(Sg,gh,Of),gh=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Rr(Sg,gh,Of),Po.dispatchEvent(new CustomEvent(vh)))}function pi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Bf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function jt(n,e,t){n.style[e]=t+"px"}function zi(n,e,t,i){let s=Ff.createElement(n);return e!=null&&pi(s,e),t?.insertBefore(s,i),s}function Ti(n,e){return zi("div",n,e)}var bg=new WeakMap;function ls(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=bg.get(n);r!=o&&(n.style.transform=r,bg.set(n,r),e<0||t<0||e>i||t>s?pi(n,Cr):Bf(n,Cr))}var Mg=new WeakMap;function wg(n,e,t){let i=e+t,s=Mg.get(n);i!=s&&(Mg.set(n,i),n.style.background=e,n.style.borderColor=t)}var Tg=new WeakMap;function Eg(n,e,t,i){let s=e+""+t,r=Tg.get(n);s!=r&&(Tg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Yf={passive:!0},zw={...Yf,capture:!0};function Rr(n,e,t,i){e.addEventListener(n,t,i?zw:Yf)}function kf(n,e,t,i){e.removeEventListener(n,t,Yf)}Uo&&Of();function Vi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function e_(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var t_=n=>n!=null,n_=n=>n!=null&&n>0,Mh=e_(t_),Vw=e_(n_);function Gw(n,e,t,i=0,s=!1){let r=s?Vw:Mh,o=s?n_:t_;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Gt,l??-Gt]}function wh(n,e,t,i){let s=Rg(n),r=Rg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ps:i_,a=s==1?mi:Ei,l=r==1?Ei:mi,c=a(o(Tn(n))),u=l(o(Tn(e))),f=Io(t,c),h=Io(t,u);return t==10&&(c<0&&(f=Ht(f,-c)),u<0&&(h=Ht(h,-u))),i||t==2?(n=f*s,e=h*r):(n=a_(n,f),e=Th(e,h)),[n,e]}function Zf(n,e,t,i){let s=wh(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var jf=.1,Ag={mode:3,pad:jf},Wa={pad:0,soft:null,mode:0},Hw={min:Wa,max:Wa};function Sh(n,e,t,i){return Eh(t)?Cg(n,e,t):(Wa.pad=t,Wa.soft=i?0:null,Wa.mode=i?3:0,Cg(n,e,Hw))}function Et(n,e){return n??e}function Ww(n,e,t){for(e=Et(e,0),t=Et(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Cg(n,e,t){let i=t.min,s=t.max,r=Et(i.pad,0),o=Et(s.pad,0),a=Et(i.hard,-Gt),l=Et(s.hard,Gt),c=Et(i.soft,Gt),u=Et(s.soft,-Gt),f=Et(i.mode,0),h=Et(s.mode,0),d=e-n,p=Ps(d),y=ti(Tn(n),Tn(e)),g=Ps(y),m=Tn(g-p);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Gt&&(r=0),h==2&&u!=-Gt&&(o=0)));let v=d||y||1e3,A=Ps(v),b=Io(10,mi(A)),R=v*(d==0?n==0?.1:1:r),E=Ht(a_(n-R,b/10),24),_=n>=c&&(f==1||f==3&&E<=c||f==2&&E>=c)?c:Gt,T=ti(a,E<_&&n>=_?_:Gi(_,E)),V=v*(d==0?e==0?.1:1:o),F=Ht(Th(e+V,b/10),24),L=e<=u&&(h==1||h==3&&F>=u||h==2&&F<=u)?u:-Gt,D=Gi(l,F>L&&e<=L?L:ti(L,F));return T==D&&T==0&&(D=100),[T,D]}var $w=new Intl.NumberFormat(Uo?kw.language:"en-US"),Jf=n=>$w.format(n),gi=Math,yh=gi.PI,Tn=gi.abs,mi=gi.floor,wn=gi.round,Ei=gi.ceil,Gi=gi.min,ti=gi.max,Io=gi.pow,Rg=gi.sign,Ps=gi.log10,i_=gi.log2,Xw=(n,e=1)=>gi.sinh(n)*e,Lf=(n,e=1)=>gi.asinh(n/e),Gt=1/0;function Pg(n){return(Ps((n^n>>31)-(n>>31))|0)+1}function zf(n,e,t){return Gi(ti(n,e),t)}function s_(n){return typeof n=="function"}function Mt(n){return s_(n)?n:()=>n}var qw=()=>{},r_=n=>n,o_=(n,e)=>e,Yw=n=>null,Ig=n=>!0,Lg=(n,e)=>n==e,Zw=/\.\d*?(?=9{6,}|0{6,})/gm,Pr=n=>{if(c_(n)||sr.has(n))return n;let e=`${n}`,t=e.match(Zw);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Pr(s)}e${r}`}return Ht(n,i)};function Er(n,e){return Pr(Ht(Pr(n/e))*e)}function Th(n,e){return Pr(Ei(Pr(n/e))*e)}function a_(n,e){return Pr(mi(Pr(n/e))*e)}function Ht(n,e=0){if(c_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return wn(i)/t}var sr=new Map;function l_(n){return((""+n).split(".")[1]||"").length}function Xa(n,e,t,i){let s=[],r=i.map(l_);for(let o=e;o<t;o++){let a=Tn(o),l=Ht(Io(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ht(u,f);s.push(h),sr.set(h,f)}}return s}var $a={},Kf=[],Lo=[null,null],ir=Array.isArray,c_=Number.isInteger,jw=n=>n===void 0;function Dg(n){return typeof n=="string"}function Eh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Jw(n){return n!=null&&typeof n=="object"}var Kw=Object.getPrototypeOf(Uint8Array),h_="__proto__";function Do(n,e=Eh){let t;if(ir(n)){let i=n.find(s=>s!=null);if(ir(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Do(n[s],e)}else t=n.slice()}else if(n instanceof Kw)t=n.slice();else if(e(n)){t={};for(let i in n)i!=h_&&(t[i]=Do(n[i],e))}else t=n;return t}function _n(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=h_&&(Eh(n[s])?_n(n[s],Do(i[s])):n[s]=Do(i[s]))}return n}var Qw=0,eT=1,tT=2;function nT(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function iT(n,e){if(oT(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return aT(o[0])||(o=rT(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:eT,d=[];for(let p=0;p<u.length;p++){let y=u[p],g=r.get(l[p]);y===null?h!=Qw&&(f[g]=y,h==tT&&d.push(g)):f[g]=y}nT(f,d,s),i.push(f)}}return i}var sT=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function rT(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function oT(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function aT(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ti(1,mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var u_=["January","February","March","April","May","June","July","August","September","October","November","December"],f_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function d_(n){return n.slice(0,3)}var lT=f_.map(d_),cT=u_.map(d_),hT={MMMM:u_,MMM:cT,WWWW:f_,WWW:lT};function za(n){return(n<10?"0":"")+n}function uT(n){return(n<10?"00":n<100?"0":"")+n}var fT={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>za(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>za(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>za(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>za(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>za(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>uT(n.getMilliseconds())};function Qf(n,e){e=e||hT;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?fT[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var dT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function pT(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==dT?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var p_=n=>n%1==0,bh=[1,2,2.5,5],mT=Xa(10,-32,0,bh),m_=Xa(10,0,32,bh),gT=m_.filter(p_),Ar=mT.concat(m_),ed=`
`,g_="{YYYY}",Ng=ed+g_,__="{M}/{D}",Ha=ed+__,_h=Ha+"/{YY}",x_="{aa}",_T="{h}:{mm}",Ro=_T+x_,Ug=ed+Ro,Fg=":{ss}",It=null;function y_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Xa(10,0,3,bh).filter(p_):Xa(10,-3,0,bh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,g_,It,It,It,It,It,It,1],[s*28,"{MMM}",Ng,It,It,It,It,It,1],[s,__,Ng,It,It,It,It,It,1],[i,"{h}"+x_,_h,It,Ha,It,It,It,1],[t,Ro,_h,It,Ha,It,It,It,1],[e,Fg,_h+" "+Ro,It,Ha+" "+Ro,It,Ug,It,1],[n,Fg+".{fff}",_h+" "+Ro,It,Ha+" "+Ro,It,Ug,It,1]];function u(f){return(h,d,p,y,g,m)=>{let v=[],A=g>=o,b=g>=r&&g<o,R=f(p),E=Ht(R*n,3),_=Df(R.getFullYear(),A?0:R.getMonth(),b||A?1:R.getDate()),T=Ht(_*n,3);if(b||A){let V=b?g/r:0,F=A?g/o:0,L=E==T?E:Ht(Df(_.getFullYear()+F,_.getMonth()+V,1)*n,3),D=new Date(wn(L/n)),G=D.getFullYear(),P=D.getMonth();for(let W=0;L<=y;W++){let O=Df(G+F*W,P+V*W,1),N=O-f(Ht(O*n,3));L=Ht((+O+N)*n,3),L<=y&&v.push(L)}}else{let V=g>=s?s:g,F=mi(p)-mi(E),L=T+F+Th(E-T,V);v.push(L);let D=f(L),G=D.getHours()+D.getMinutes()/t+D.getSeconds()/i,P=g/i,W=h.axes[d]._space,O=m/W;for(;L=Ht(L+g,n==1?0:3),!(L>y);)if(P>1){let N=mi(Ht(G+P,6))%24,Z=f(L).getHours()-N;Z>1&&(Z=-1),L-=Z*i,G=(G+P)%24;let ne=v[v.length-1];Ht((L-ne)/g,3)*O>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[xT,yT,vT]=y_(1),[ST,bT,MT]=y_(.001);Xa(2,-53,53,[1]);function Og(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Bg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let y=n(p),g=y.getFullYear(),m=y.getMonth(),v=y.getDate(),A=y.getHours(),b=y.getMinutes(),R=y.getSeconds(),E=g!=l&&a[2]||m!=c&&a[3]||v!=u&&a[4]||A!=f&&a[5]||b!=h&&a[6]||R!=d&&a[7]||a[1];return l=g,c=m,u=v,f=A,h=b,d=R,E(y)})}}function wT(n,e){let t=Qf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Df(n,e,t){return new Date(n,e,t)}function kg(n,e){return e(n)}var TT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function zg(n,e){return(t,i,s,r)=>r==null?qf:e(n(i))}function ET(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function AT(n,e){return n.series[e].fill(n,e)}var CT={show:!0,live:!0,isolate:!1,mount:qw,markers:{show:!0,width:2,stroke:ET,fill:AT,dash:"solid"},idx:null,idxs:null,values:[]};function RT(n,e){let t=n.cursor.points,i=Ti(),s=t.size(n,e);jt(i,Va,s),jt(i,Ga,s);let r=s/-2;jt(i,"marginLeft",r),jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&jt(i,"borderWidth",o),i}function PT(n,e){let t=n.series[e].points;return t._fill||t._stroke}function IT(n,e){let t=n.series[e].points;return t._stroke||t._fill}function LT(n,e){return n.series[e].points.size}var Nf=[0,0];function DT(n,e,t){return Nf[0]=e,Nf[1]=t,Nf}function xh(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Uf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var NT={show:!0,x:!0,y:!0,lock:!1,move:DT,points:{one:!1,show:RT,size:LT,width:0,stroke:IT,fill:PT},bind:{mousedown:xh,mouseup:xh,click:xh,dblclick:xh,mousemove:Uf,mouseleave:Uf,mouseenter:Uf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},v_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},td=_n({},v_,{filter:o_}),S_=_n({},td,{size:10}),b_=_n({},v_,{show:!1}),nd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',M_="bold "+nd,w_=1.5,Vg={show:!0,scale:"x",stroke:Xf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M_,side:2,grid:td,ticks:S_,border:b_,font:nd,lineGap:w_,rotate:0},UT="Value",FT="Time",Gg={show:!0,scale:"x",auto:!1,sorted:1,min:Gt,max:-Gt,idxs:[]};function OT(n,e,t,i,s){return e.map(r=>r==null?"":Jf(r))}function BT(n,e,t,i,s,r,o){let a=[],l=sr.get(s)||0;t=o?t:Ht(Th(t,s),l);for(let c=t;c<=i;c=Ht(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Vf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ps:i_,u=mi(c(t));s=Io(l,u),l==10&&(s=Ar[Vi(s,Ar)]);let f=t,h=s*l;l==10&&(h=Ar[Vi(h,Ar)]);do a.push(f),f=f+s,l==10&&!sr.has(f)&&(f=Ht(f,sr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Ar[Vi(h,Ar)]));while(f<=i);return a}function kT(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Vf(n,e,ti(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Vf(n,e,ti(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var T_=/./,zT=/[12357]/,VT=/[125]/,Hg=/1/,Gf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function GT(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?T_:l(7,o)-u>=c?zT:l(5,o)-u>=c?VT:Hg;if(f==Hg){let h=Tn(l(1,o)-u);if(h<c)return Gf(e.slice().reverse(),a.distr,f,Ei(c/h)).reverse()}return Gf(e,a.distr,f,1)}function HT(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Tn(l(1,o)-l(2,o));return c<a?Gf(e.slice().reverse(),3,T_,Ei(a/c)).reverse():e}function WT(n,e,t,i){return i==null?qf:e==null?"":Jf(e)}var Wg={show:!0,scale:"y",stroke:Xf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M_,side:3,grid:td,ticks:S_,border:b_,font:nd,lineGap:w_,rotate:0};function $T(n,e){let t=3+(n||1)*2;return Ht(t*e,3)}function XT(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Tn(o-r),l=n.series[e],c=a/(l.points.space*Rt);return i[1]-i[0]<=c}var $g={scale:null,auto:!0,sorted:0,min:Gt,max:-Gt},E_=(n,e,t,i,s)=>s,Xg={show:!0,auto:!0,sorted:0,gaps:E_,alpha:1,facets:[_n({},$g,{scale:"x"}),_n({},$g,{scale:"y"})]},qg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:E_,alpha:1,points:{show:XT,filter:null},values:null,min:Gt,max:-Gt,idxs:[],path:null,clip:null};function qT(n,e,t,i,s){return t/10}var A_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},YT=_n({},A_,{time:!1,ori:1}),Yg={};function C_(n,e){let t=Yg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Yg[n]=t)),t}var No=1,Hf=2;function Ir(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,y=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,g,m,h,d,p,y,Ch,Fo,Ph,P_,L_):t(s,l,c,u,f,m,g,d,h,y,p,Rh,Oo,rd,I_,D_)}function id(n,e){let t=0,i=0,s=Et(n.bands,Kf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function ZT(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Is(n,e,t,i,s,r){return Ir(n,e,(o,a,l,c,u,f,h,d,p,y,g)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?Fo:Oo,b,R;v==1?(b=t,R=i):(b=i,R=t);let E=m(f(a[b],c,y,d)),_=m(h(l[b],u,g,p)),T=m(f(a[R],c,y,d)),V=m(h(r==1?u.max:u.min,u,g,p)),F=new Path2D(s);return A(F,T,V),A(F,E,V),A(F,E,_),F})}function Ah(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ph:rd,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function jT(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function sd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),y=f-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let m=h+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function Zg(n){return n==0?r_:n==1?wn:e=>Er(e,n)}function R_(n){let e=n==0?Ch:Rh,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Gi(c,a/2,l/2),u=Gi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Ch=(n,e,t)=>{n.moveTo(e,t)},Rh=(n,e,t)=>{n.moveTo(t,e)},Fo=(n,e,t)=>{n.lineTo(e,t)},Oo=(n,e,t)=>{n.lineTo(t,e)},Ph=R_(0),rd=R_(1),P_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},I_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},L_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},D_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function N_(n){return(e,t,i,s,r)=>Ir(e,t,(o,a,l,c,u,f,h,d,p,y,g)=>{let{pxRound:m,points:v}=o,A,b;c.ori==0?(A=Ch,b=P_):(A=Rh,b=I_);let R=Ht(v.width*Rt,3),E=(v.size-v.width)/2*Rt,_=Ht(E*2,3),T=new Path2D,V=new Path2D,{left:F,top:L,width:D,height:G}=e.bbox;Ph(V,F-_,L-_,D+_*2,G+_*2);let P=W=>{if(l[W]!=null){let O=m(f(a[W],c,y,d)),N=m(h(l[W],u,g,p));A(T,O+E,N),b(T,O,N,E,0,yh*2)}};if(r)r.forEach(P);else for(let W=i;W<=s;W++)P(W);return{stroke:R>0?T:null,fill:T,clip:V,flags:No|Hf}})}function U_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var JT=U_(Fo),KT=U_(Oo);function F_(n){let e=Et(n?.alignGaps,0);return(t,i,s,r)=>Ir(t,i,(o,a,l,c,u,f,h,d,p,y,g)=>{[s,r]=Mh(l,s,r);let m=o.pxRound,v=G=>m(f(G,c,y,d)),A=G=>m(h(G,u,g,p)),b,R;c.ori==0?(b=Fo,R=JT):(b=Oo,R=KT);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:No},T=_.stroke,V=!1;if(r-s>=y*4){let G=ue=>t.posToVal(ue,c.key,!0),P=null,W=null,O,N,j,$=v(a[E==1?s:r]),Z=v(a[s]),ne=v(a[r]),fe=G(E==1?Z+1:ne-1);for(let ue=E==1?s:r;ue>=s&&ue<=r;ue+=E){let te=a[ue],ye=(E==1?te<fe:te>fe)?$:v(te),Ce=l[ue];ye==$?Ce!=null?(N=Ce,P==null?(b(T,ye,A(N)),O=P=W=N):N<P?P=N:N>W&&(W=N)):Ce===null&&(V=!0):(P!=null&&R(T,$,A(P),A(W),A(O),A(N)),Ce!=null?(N=Ce,b(T,ye,A(N)),P=W=O=N):(P=W=null,Ce===null&&(V=!0)),$=ye,fe=G($+E))}P!=null&&P!=W&&j!=$&&R(T,$,A(P),A(W),A(O),A(N))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let P=l[G];P===null?V=!0:P!=null&&b(T,v(a[G]),A(P))}let[L,D]=id(t,i);if(o.fill!=null||L!=0){let G=_.fill=new Path2D(T),P=o.fillTo(t,i,o.min,o.max,L),W=A(P),O=v(a[s]),N=v(a[r]);E==-1&&([N,O]=[O,N]),b(G,N,W),b(G,O,W)}if(!o.spanGaps){let G=[];V&&G.push(...sd(a,l,s,r,E,v,e)),_.gaps=G=o.gaps(t,i,s,r,G),_.clip=Ah(G,c.ori,d,p,y,g)}return D!=0&&(_.band=D==2?[Is(t,i,s,r,T,-1),Is(t,i,s,r,T,1)]:Is(t,i,s,r,T,D)),_})}function QT(n){let e=Et(n.align,1),t=Et(n.ascDesc,!1),i=Et(n.alignGaps,0),s=Et(n.extend,!1);return(r,o,a,l)=>Ir(r,o,(c,u,f,h,d,p,y,g,m,v,A)=>{[a,l]=Mh(f,a,l);let b=c.pxRound,{left:R,width:E}=r.bbox,_=Z=>b(p(Z,h,v,g)),T=Z=>b(y(Z,d,A,m)),V=h.ori==0?Fo:Oo,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:No},L=F.stroke,D=h.dir*(h.ori==0?1:-1),G=T(f[D==1?a:l]),P=_(u[D==1?a:l]),W=P,O=P;s&&e==-1&&(O=R,V(L,O,G)),V(L,P,G);for(let Z=D==1?a:l;Z>=a&&Z<=l;Z+=D){let ne=f[Z];if(ne==null)continue;let fe=_(u[Z]),ue=T(ne);e==1?V(L,fe,G):V(L,W,ue),V(L,fe,ue),G=ue,W=fe}let N=W;s&&e==1&&(N=R+E,V(L,N,G));let[j,$]=id(r,o);if(c.fill!=null||j!=0){let Z=F.fill=new Path2D(L),ne=c.fillTo(r,o,c.min,c.max,j),fe=T(ne);V(Z,N,fe),V(Z,O,fe)}if(!c.spanGaps){let Z=[];Z.push(...sd(u,f,a,l,D,_,i));let ne=c.width*Rt/2,fe=t||e==1?ne:-ne,ue=t||e==-1?-ne:ne;Z.forEach(te=>{te[0]+=fe,te[1]+=ue}),F.gaps=Z=c.gaps(r,o,a,l,Z),F.clip=Ah(Z,h.ori,g,m,v,A)}return $!=0&&(F.band=$==2?[Is(r,o,a,l,L,-1),Is(r,o,a,l,L,1)]:Is(r,o,a,l,L,$)),F})}function jg(n,e,t,i,s,r,o=Gt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Tn(n[l]-n[a]);u<c&&(c=u,o=Tn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function eE(n){n=n||$a;let e=Et(n.size,[.6,Gt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Mt(s),o=1-e[0],a=Et(e[1],Gt),l=Et(e[2],1),c=Et(n.disp,$a),u=Et(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,y,g)=>Ir(d,p,(m,v,A,b,R,E,_,T,V,F,L)=>{let D=m.pxRound,G=t,P=i*Rt,W=a*Rt,O=l*Rt,N,j;b.ori==0?[N,j]=r(d,p):[j,N]=r(d,p);let $=b.dir*(b.ori==0?1:-1),Z=b.ori==0?Ph:rd,ne=b.ori==0?u:(Pe,Je,ht,we,kt,Ge,Ye)=>{u(Pe,Je,ht,kt,we,Ye,Ge)},fe=Et(d.bands,Kf).find(Pe=>Pe.series[0]==p),ue=fe!=null?fe.dir:0,te=m.fillTo(d,p,m.min,m.max,ue),ge=D(_(te,R,L,V)),ye,Ce,Me,$e=F,ct=D(m.width*Rt),He=!1,gt=null,dt=null,at=null,Jt=null;f!=null&&(ct==0||h!=null)&&(He=!0,gt=f.values(d,p,y,g),dt=new Map,new Set(gt).forEach(Pe=>{Pe!=null&&dt.set(Pe,new Path2D)}),ct>0&&(at=h.values(d,p,y,g),Jt=new Map,new Set(at).forEach(Pe=>{Pe!=null&&Jt.set(Pe,new Path2D)})));let{x0:Wt,size:hn}=c;if(Wt!=null&&hn!=null){G=1,v=Wt.values(d,p,y,g),Wt.unit==2&&(v=v.map(ht=>d.posToVal(T+ht*F,b.key,!0)));let Pe=hn.values(d,p,y,g);hn.unit==2?Ce=Pe[0]*F:Ce=E(Pe[0],b,F,T)-E(0,b,F,T),$e=jg(v,A,E,b,F,T,$e),Me=$e-Ce+P}else $e=jg(v,A,E,b,F,T,$e),Me=$e*o+P,Ce=$e-Me;Me<1&&(Me=0),ct>=Ce/2&&(ct=0),Me<5&&(D=r_);let Ut=Me>0,En=$e-Me-(Ut?ct:0);Ce=D(zf(En,O,W)),ye=(G==0?Ce/2:G==$?0:Ce)-G*$*((G==0?P/2:0)+(Ut?ct/2:0));let wt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=He?null:new Path2D,nn=null;if(fe!=null)nn=d.data[fe.series[1]];else{let{y0:Pe,y1:Je}=c;Pe!=null&&Je!=null&&(A=Je.values(d,p,y,g),nn=Pe.values(d,p,y,g))}let un=N*Ce,z=j*Ce;for(let Pe=$==1?y:g;Pe>=y&&Pe<=g;Pe+=$){let Je=A[Pe];if(Je==null)continue;if(nn!=null){let q=nn[Pe]??0;if(Je-q==0)continue;ge=_(q,R,L,V)}let ht=b.distr!=2||c!=null?v[Pe]:Pe,we=E(ht,b,F,T),kt=_(Et(Je,te),R,L,V),Ge=D(we-ye),Ye=D(ti(kt,ge)),C=D(Gi(kt,ge)),S=Ye-C;if(Je!=null){let q=Je<0?z:un,he=Je<0?un:z;He?(ct>0&&at[Pe]!=null&&Z(Jt.get(at[Pe]),Ge,C+mi(ct/2),Ce,ti(0,S-ct),q,he),gt[Pe]!=null&&Z(dt.get(gt[Pe]),Ge,C+mi(ct/2),Ce,ti(0,S-ct),q,he)):Z(xn,Ge,C+mi(ct/2),Ce,ti(0,S-ct),q,he),ne(d,p,Pe,Ge-ct/2,C,Ce+ct,S)}}return ct>0?wt.stroke=He?Jt:xn:He||(wt._fill=m.width==0?m._fill:m._stroke??m._fill,wt.width=0),wt.fill=He?dt:xn,wt})}function tE(n,e){let t=Et(e?.alignGaps,0);return(i,s,r,o)=>Ir(i,s,(a,l,c,u,f,h,d,p,y,g,m)=>{[r,o]=Mh(c,r,o);let v=a.pxRound,A=N=>v(h(N,u,g,p)),b=N=>v(d(N,f,m,y)),R,E,_;u.ori==0?(R=Ch,_=Fo,E=L_):(R=Rh,_=Oo,E=D_);let T=u.dir*(u.ori==0?1:-1),V=A(l[T==1?r:o]),F=V,L=[],D=[];for(let N=T==1?r:o;N>=r&&N<=o;N+=T)if(c[N]!=null){let $=l[N],Z=A($);L.push(F=Z),D.push(b(c[N]))}let G={stroke:n(L,D,R,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:No},P=G.stroke,[W,O]=id(i,s);if(a.fill!=null||W!=0){let N=G.fill=new Path2D(P),j=a.fillTo(i,s,a.min,a.max,W),$=b(j);_(N,F,$),_(N,V,$)}if(!a.spanGaps){let N=[];N.push(...sd(l,c,r,o,T,A,t)),G.gaps=N=a.gaps(i,s,r,o,N),G.clip=Ah(N,u.ori,p,y,g,m)}return O!=0&&(G.band=O==2?[Is(i,s,r,o,P,-1),Is(i,s,r,o,P,1)]:Is(i,s,r,o,P,O)),G})}function nE(n){return tE(iE,n)}function iE(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var Wf=new Set;function Jg(){for(let n of Wf)n.syncRect(!0)}Uo&&(Rr(Ow,Po,Jg),Rr(Bw,Po,Jg,!0),Rr(vh,Po,()=>{Nn.pxRatio=Rt}));var sE=F_(),rE=N_();function Kg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>$f(r,o,e,t))}function oE(n,e){return n.map((t,i)=>i==0?{}:_n({},e,t))}function $f(n,e,t,i){return _n({},e==0?t:i,n)}function O_(n,e,t){return e==null?Lo:[e,t]}var aE=O_;function lE(n,e,t){return e==null?Lo:Sh(e,t,jf,!0)}function B_(n,e,t,i){return e==null?Lo:wh(e,t,n.scales[i].log,!1)}var cE=B_;function k_(n,e,t,i){return e==null?Lo:Zf(e,t,n.scales[i].log,!1)}var hE=k_;function uE(n,e,t,i,s){let r=ti(Pg(n),Pg(e)),o=e-n,a=Vi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?sr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Qg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=wn((t=+s)*Rt))+"px"),[n,e,t]}function fE(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ht(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Nn(n,e,t){let i={mode:Et(n.mode,1)},s=i.mode;function r(x,M,I,U){let X=M.valToPct(x);return U+I*(M.dir==-1?1-X:X)}function o(x,M,I,U){let X=M.valToPct(x);return U+I*(M.dir==-1?X:1-X)}function a(x,M,I,U){return M.ori==0?r(x,M,I,U):o(x,M,I,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ti(yw);if(n.id!=null&&(c.id=n.id),pi(c,n.class),n.title){let x=Ti(bw,c);x.textContent=n.title}let u=zi("canvas"),f=i.ctx=u.getContext("2d"),h=Ti(Mw,c);Rr("click",h,x=>{x.target===p&&(Xt!=kr||Kt!=zr)&&On.click(i,x)},!0);let d=i.under=Ti(ww,h);h.appendChild(u);let p=i.over=Ti(Tw,h);n=Do(n);let y=+Et(n.pxAlign,1),g=Zg(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,v=i.series=s==1?Kg(n.series||[],Gg,qg,!1):oE(n.series||[null],Xg),A=i.axes=Kg(n.axes||[],Vg,Wg,!0),b=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=Mt(x.fill||null),x.dir=Et(x.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ps,series:xt},T=(n.drawOrder||["axes","series"]).map(x=>_[x]);function V(x){let M=x.distr==3?I=>Ps(I>0?I:x.clamp(i,I,x.min,x.max,x.key)):x.distr==4?I=>Lf(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let U=M(I),{_min:X,_max:Q}=x,le=Q-X;return(U-X)/le}}function F(x){let M=b[x];if(M==null){let I=(n.scales||$a)[x]||$a;if(I.from!=null){F(I.from);let U=_n({},b[I.from],I,{key:x});U.valToPct=V(U),b[x]=U}else{M=b[x]=_n({},x==E?A_:YT,I),M.key=x;let U=M.time,X=M.range,Q=ir(X);if((x!=E||s==2&&!U)&&(Q&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Ag:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Ag:{mode:1,hard:X[1],soft:X[1]}},Q=!1),!Q&&Eh(X))){let le=X;X=(pe,Se,Ue)=>Se==null?Lo:Sh(Se,Ue,le)}M.range=Mt(X||(U?aE:x==E?M.distr==3?cE:M.distr==4?hE:O_:M.distr==3?B_:M.distr==4?k_:lE)),M.auto=Mt(Q?!1:M.auto),M.clamp=Mt(M.clamp||qT),M._min=M._max=null,M.valToPct=V(M)}}}F("x"),F("y"),s==1&&v.forEach(x=>{F(x.scale)}),A.forEach(x=>{F(x.scale)});for(let x in n.scales)F(x);let L=b[E],D=L.distr,G,P;L.ori==0?(pi(c,vw),G=r,P=o):(pi(c,Sw),G=o,P=r);let W={};for(let x in b){let M=b[x];(M.min!=null||M.max!=null)&&(W[x]={min:M.min,max:M.max},M.min=M.max=null)}let O=n.tzDate||(x=>new Date(wn(x/m))),N=n.fmtDate||Qf,j=m==1?vT(O):MT(O),$=Bg(O,Og(m==1?yT:bT,N)),Z=zg(O,kg(TT,N)),ne=[],fe=i.legend=_n({},CT,n.legend),ue=i.cursor=_n({},NT,{drag:{y:s==2}},n.cursor),te=fe.show,ge=ue.show,ye=fe.markers;fe.idxs=ne,ye.width=Mt(ye.width),ye.dash=Mt(ye.dash),ye.stroke=Mt(ye.stroke),ye.fill=Mt(ye.fill);let Ce,Me,$e,ct=[],He=[],gt,dt=!1,at={};if(fe.live){let x=v[1]?v[1].values:null;dt=x!=null,gt=dt?x(i,1,0):{_:0};for(let M in gt)at[M]=qf}if(te)if(Ce=zi("table",Iw,c),$e=zi("tbody",null,Ce),fe.mount(i,Ce),dt){Me=zi("thead",null,Ce,$e);let x=zi("tr",null,Me);zi("th",null,x);for(var Jt in gt)zi("th",pg,x).textContent=Jt}else pi(Ce,Dw),fe.live&&pi(Ce,Lw);let Wt={show:!0},hn={show:!1};function Ut(x,M){if(M==0&&(dt||!fe.live||s==2))return Lo;let I=[],U=zi("tr",Nw,$e,$e.childNodes[M]);pi(U,x.class),x.show||pi(U,Cr);let X=zi("th",null,U);if(ye.show){let pe=Ti(Uw,X);if(M>0){let Se=ye.width(i,M);Se&&(pe.style.border=Se+"px "+ye.dash(i,M)+" "+ye.stroke(i,M)),pe.style.background=ye.fill(i,M)}}let Q=Ti(pg,X);x.label instanceof HTMLElement?Q.appendChild(x.label):Q.textContent=x.label,M>0&&(ye.show||(Q.style.color=x.width>0?ye.stroke(i,M):ye.fill(i,M)),wt("click",X,pe=>{if(ue._lock)return;tt(pe);let Se=v.indexOf(x);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Ue=v.some((Fe,Be)=>Be>0&&Be!=Se&&Fe.show);v.forEach((Fe,Be)=>{Be>0&&Xi(Be,Ue?Be==Se?Wt:hn:Wt,!0,mn.setSeries)})}else Xi(Se,{show:!x.show},!0,mn.setSeries)},!1),nt&&wt(xg,X,pe=>{ue._lock||(tt(pe),Xi(v.indexOf(x),Gr,!0,mn.setSeries))},!1));for(var le in gt){let pe=zi("td",Fw,U);pe.textContent="--",I.push(pe)}return[U,I]}let En=new Map;function wt(x,M,I,U=!0){let X=En.get(M)||{},Q=ue.bind[x](i,M,I,U);Q&&(Rr(x,M,X[x]=Q),En.set(M,X))}function xn(x,M,I){let U=En.get(M)||{};for(let X in U)(x==null||X==x)&&(kf(X,M,U[X]),delete U[X]);x==null&&En.delete(M)}let nn=0,un=0,z=0,Pe=0,Je=0,ht=0,we=Je,kt=ht,Ge=z,Ye=Pe,C=0,S=0,q=0,he=0;i.bbox={};let ae=!1,xe=!1,ve=!1,ie=!1,re=!1,me=!1;function k(x,M,I){(I||x!=i.width||M!=i.height)&&oe(x,M),pt(!1),ve=!0,xe=!0,Bn()}function oe(x,M){i.width=nn=z=x,i.height=un=Pe=M,Je=ht=0,be(),We();let I=i.bbox;C=I.left=Er(Je*Rt,.5),S=I.top=Er(ht*Rt,.5),q=I.width=Er(z*Rt,.5),he=I.height=Er(Pe*Rt,.5)}let se=3;function Te(){let x=!1,M=0;for(;!x;){M++;let I=Fr(M),U=$i(M);x=M==se||I&&U,x||(oe(i.width,i.height),xe=!0)}}function _e({width:x,height:M}){k(x,M)}i.setSize=_e;function be(){let x=!1,M=!1,I=!1,U=!1;A.forEach((X,Q)=>{if(X.show&&X._show){let{side:le,_size:pe}=X,Se=le%2,Ue=X.label!=null?X.labelSize:0,Fe=pe+Ue;Fe>0&&(Se?(z-=Fe,le==3?(Je+=Fe,U=!0):I=!0):(Pe-=Fe,le==0?(ht+=Fe,x=!0):M=!0))}}),Hi[0]=x,Hi[1]=I,Hi[2]=M,Hi[3]=U,z-=Ai[1]+Ai[3],Je+=Ai[3],Pe-=Ai[2]+Ai[0],ht+=Ai[0]}function We(){let x=Je+z,M=ht+Pe,I=Je,U=ht;function X(Q,le){switch(Q){case 1:return x+=le,x-le;case 2:return M+=le,M-le;case 3:return I-=le,I+le;case 0:return U-=le,U+le}}A.forEach((Q,le)=>{if(Q.show&&Q._show){let pe=Q.side;Q._pos=X(pe,Q._size),Q.label!=null&&(Q._lpos=X(pe,Q.labelSize))}})}if(ue.dataIdx==null){let x=ue.hover,M=x.skip=new Set(x.skip??[]);M.add(void 0);let I=x.prox=Mt(x.prox),U=x.bias??=0;ue.dataIdx=(X,Q,le,pe)=>{if(Q==0)return le;let Se=le,Ue=I(X,Q,le,pe)??Gt,Fe=Ue>=0&&Ue<Gt,Be=L.ori==0?z:Pe,lt=ue.left,At=e[0],Tt=e[Q];if(M.has(Tt[le])){Se=null;let vt=null,et=null,Xe;if(U==0||U==-1)for(Xe=le;vt==null&&Xe-- >0;)M.has(Tt[Xe])||(vt=Xe);if(U==0||U==1)for(Xe=le;et==null&&Xe++<Tt.length;)M.has(Tt[Xe])||(et=Xe);if(vt!=null||et!=null)if(Fe){let Yt=vt==null?-1/0:G(At[vt],L,Be,0),on=et==null?1/0:G(At[et],L,Be,0),Pn=lt-Yt,Ft=on-lt;Pn<=Ft?Pn<=Ue&&(Se=vt):Ft<=Ue&&(Se=et)}else Se=et==null?vt:vt==null?et:le-vt<=et-le?vt:et}else Fe&&Tn(lt-G(At[le],L,Be,0))>Ue&&(Se=null);return Se}}let tt=x=>{ue.event=x};ue.idxs=ne,ue._lock=!1;let ce=ue.points;ce.show=Mt(ce.show),ce.size=Mt(ce.size),ce.stroke=Mt(ce.stroke),ce.width=Mt(ce.width),ce.fill=Mt(ce.fill);let ke=i.focus=_n({},n.focus||{alpha:.3},ue.focus),nt=ke.prox>=0,Re=nt&&ce.one,ft=[],$t=[],$n=[];function zo(x,M){let I=ce.show(i,M);if(I instanceof HTMLElement)return pi(I,Pw),pi(I,x.class),ls(I,-10,-10,z,Pe),p.insertBefore(I,ft[M]),I}function Dr(x,M){if(s==1||M>0){let I=s==1&&b[x.scale].time,U=x.value;x.value=I?Dg(U)?zg(O,kg(U,N)):U||Z:U||WT,x.label=x.label||(I?FT:UT)}if(Re||M>0){x.width=x.width==null?1:x.width,x.paths=x.paths||sE||Yw,x.fillTo=Mt(x.fillTo||ZT),x.pxAlign=+Et(x.pxAlign,y),x.pxRound=Zg(x.pxAlign),x.stroke=Mt(x.stroke||null),x.fill=Mt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=$T(ti(1,x.width),1),U=x.points=_n({},{size:I,width:ti(1,I*.2),stroke:x.stroke,space:I*2,paths:rE,_stroke:null,_fill:null},x.points);U.show=Mt(U.show),U.filter=Mt(U.filter),U.fill=Mt(U.fill),U.stroke=Mt(U.stroke),U.paths=Mt(U.paths),U.pxAlign=x.pxAlign}if(te){let I=Ut(x,M);ct.splice(M,0,I[0]),He.splice(M,0,I[1]),fe.values.push(null)}if(ge){ne.splice(M,0,null);let I=null;Re?M==0&&(I=zo(x,M)):M>0&&(I=zo(x,M)),ft.splice(M,0,I),$t.splice(M,0,0),$n.splice(M,0,0)}Rn("addSeries",M)}function Uh(x,M){M=M??v.length,x=s==1?$f(x,M,Gg,qg):$f(x,M,{},Xg),v.splice(M,0,x),Dr(v[M],M)}i.addSeries=Uh;function Ja(x){if(v.splice(x,1),te){fe.values.splice(x,1),He.splice(x,1);let M=ct.splice(x,1)[0];xn(null,M.firstChild),M.remove()}ge&&(ne.splice(x,1),ft.splice(x,1)[0].remove(),$t.splice(x,1),$n.splice(x,1)),Rn("delSeries",x)}i.delSeries=Ja;let Hi=[!1,!1,!1,!1];function us(x,M){if(x._show=x.show,x.show){let I=x.side%2,U=b[x.scale];U==null&&(x.scale=I?v[1].scale:E,U=b[x.scale]);let X=U.time;x.size=Mt(x.size),x.space=Mt(x.space),x.rotate=Mt(x.rotate),ir(x.incrs)&&x.incrs.forEach(le=>{!sr.has(le)&&sr.set(le,l_(le))}),x.incrs=Mt(x.incrs||(U.distr==2?gT:X?m==1?xT:ST:Ar)),x.splits=Mt(x.splits||(X&&U.distr==1?j:U.distr==3?Vf:U.distr==4?kT:BT)),x.stroke=Mt(x.stroke),x.grid.stroke=Mt(x.grid.stroke),x.ticks.stroke=Mt(x.ticks.stroke),x.border.stroke=Mt(x.border.stroke);let Q=x.values;x.values=ir(Q)&&!ir(Q[0])?Mt(Q):X?ir(Q)?Bg(O,Og(Q,N)):Dg(Q)?wT(O,Q):Q||$:Q||OT,x.filter=Mt(x.filter||(U.distr>=3&&U.log==10?GT:U.distr==3&&U.log==2?HT:o_)),x.font=Qg(x.font),x.labelFont=Qg(x.labelFont),x._size=x.size(i,null,M,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Hi[M]=!0,x._el=Ti(Ew,h))}}function fs(x,M,I,U){let[X,Q,le,pe]=I,Se=M%2,Ue=0;return Se==0&&(pe||Q)&&(Ue=M==0&&!X||M==2&&!le?wn(Vg.size/3):0),Se==1&&(X||le)&&(Ue=M==1&&!Q||M==3&&!pe?wn(Wg.size/2):0),Ue}let Vo=i.padding=(n.padding||[fs,fs,fs,fs]).map(x=>Mt(Et(x,fs))),Ai=i._padding=Vo.map((x,M)=>x(i,M,Hi,0)),sn,ln=null,cn=null,Wi=s==1?v[0].idxs:null,si=null,Ds=!1;function Go(x,M){if(e=x??[],i.data=i._data=e,s==2){sn=0;for(let I=1;I<v.length;I++)sn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),si=e[0],sn=si.length;let I=e;if(D==2){I=e.slice();let U=I[0]=Array(sn);for(let X=0;X<sn;X++)U[X]=X}i._data=e=I}if(pt(!0),Rn("setData"),D==2&&(ve=!0),M!==!1){let I=L;I.auto(i,Ds)?Ho():Fs(E,I.min,I.max),ie=ie||ue.left>=0,me=!0,Bn()}}i.setData=Go;function Ho(){Ds=!0;let x,M;s==1&&(sn>0?(ln=Wi[0]=0,cn=Wi[1]=sn-1,x=e[0][ln],M=e[0][cn],D==2?(x=ln,M=cn):x==M&&(D==3?[x,M]=wh(x,x,L.log,!1):D==4?[x,M]=Zf(x,x,L.log,!1):L.time?M=x+wn(86400/m):[x,M]=Sh(x,M,jf,!0))):(ln=Wi[0]=x=null,cn=Wi[1]=M=null)),Fs(E,x,M)}let Nr,Ns,Ur,w,H,ee,J,K,Ee,Le;function Ae(x,M,I,U,X,Q){x??=gg,I??=Kf,U??="butt",X??=gg,Q??="round",x!=Nr&&(f.strokeStyle=Nr=x),X!=Ns&&(f.fillStyle=Ns=X),M!=Ur&&(f.lineWidth=Ur=M),Q!=H&&(f.lineJoin=H=Q),U!=ee&&(f.lineCap=ee=U),I!=w&&f.setLineDash(w=I)}function De(x,M,I,U){M!=Ns&&(f.fillStyle=Ns=M),x!=J&&(f.font=J=x),I!=K&&(f.textAlign=K=I),U!=Ee&&(f.textBaseline=Ee=U)}function Ve(x,M,I,U,X=0){if(U.length>0&&x.auto(i,Ds)&&(M==null||M.min==null)){let Q=Et(ln,0),le=Et(cn,U.length-1),pe=I.min==null?Gw(U,Q,le,X,x.distr==3):[I.min,I.max];x.min=Gi(x.min,I.min=pe[0]),x.max=ti(x.max,I.max=pe[1])}}let st={min:null,max:null};function _t(){for(let U in b){let X=b[U];W[U]==null&&(X.min==null||W[E]!=null&&X.auto(i,Ds))&&(W[U]=st)}for(let U in b){let X=b[U];W[U]==null&&X.from!=null&&W[X.from]!=null&&(W[U]=st)}W[E]!=null&&pt(!0);let x={};for(let U in W){let X=W[U];if(X!=null){let Q=x[U]=Do(b[U],Jw);if(X.min!=null)_n(Q,X);else if(U!=E||s==2)if(sn==0&&Q.from==null){let le=Q.range(i,null,null,U);Q.min=le[0],Q.max=le[1]}else Q.min=Gt,Q.max=-Gt}}if(sn>0){v.forEach((U,X)=>{if(s==1){let Q=U.scale,le=W[Q];if(le==null)return;let pe=x[Q];if(X==0){let Se=pe.range(i,pe.min,pe.max,Q);pe.min=Se[0],pe.max=Se[1],ln=Vi(pe.min,e[0]),cn=Vi(pe.max,e[0]),cn-ln>1&&(e[0][ln]<pe.min&&ln++,e[0][cn]>pe.max&&cn--),U.min=si[ln],U.max=si[cn]}else U.show&&U.auto&&Ve(pe,le,U,e[X],U.sorted);U.idxs[0]=ln,U.idxs[1]=cn}else if(X>0&&U.show&&U.auto){let[Q,le]=U.facets,pe=Q.scale,Se=le.scale,[Ue,Fe]=e[X],Be=x[pe],lt=x[Se];Be!=null&&Ve(Be,W[pe],Q,Ue,Q.sorted),lt!=null&&Ve(lt,W[Se],le,Fe,le.sorted),U.min=le.min,U.max=le.max}});for(let U in x){let X=x[U],Q=W[U];if(X.from==null&&(Q==null||Q.min==null)){let le=X.range(i,X.min==Gt?null:X.min,X.max==-Gt?null:X.max,U);X.min=le[0],X.max=le[1]}}}for(let U in x){let X=x[U];if(X.from!=null){let Q=x[X.from];if(Q.min==null)X.min=X.max=null;else{let le=X.range(i,Q.min,Q.max,U);X.min=le[0],X.max=le[1]}}}let M={},I=!1;for(let U in x){let X=x[U],Q=b[U];if(Q.min!=X.min||Q.max!=X.max){Q.min=X.min,Q.max=X.max;let le=Q.distr;Q._min=le==3?Ps(Q.min):le==4?Lf(Q.min,Q.asinh):le==100?Q.fwd(Q.min):Q.min,Q._max=le==3?Ps(Q.max):le==4?Lf(Q.max,Q.asinh):le==100?Q.fwd(Q.max):Q.max,M[U]=I=!0}}if(I){v.forEach((U,X)=>{s==2?X>0&&M.y&&(U._paths=null):M[U.scale]&&(U._paths=null)});for(let U in M)ve=!0,Rn("setScale",U);ge&&ue.left>=0&&(ie=me=!0)}for(let U in W)W[U]=null}function ze(x){let M=zf(ln-1,0,sn-1),I=zf(cn+1,0,sn-1);for(;x[M]==null&&M>0;)M--;for(;x[I]==null&&I<sn-1;)I++;return[M,I]}function xt(){if(sn>0){let x=v.some(M=>M._focus)&&Le!=ke.alpha;x&&(f.globalAlpha=Le=ke.alpha),v.forEach((M,I)=>{if(I>0&&M.show&&(en(I,!1),en(I,!0),M._paths==null)){let U=Le;Le!=M.alpha&&(f.globalAlpha=Le=M.alpha);let X=s==2?[0,e[I][0].length-1]:ze(e[I]);M._paths=M.paths(i,I,X[0],X[1]),Le!=U&&(f.globalAlpha=Le=U)}}),v.forEach((M,I)=>{if(I>0&&M.show){let U=Le;Le!=M.alpha&&(f.globalAlpha=Le=M.alpha),M._paths!=null&&Lt(I,!1);{let X=M._paths!=null?M._paths.gaps:null,Q=M.points.show(i,I,ln,cn,X),le=M.points.filter(i,I,Q,X);(Q||le)&&(M.points._paths=M.points.paths(i,I,ln,cn,le),Lt(I,!0))}Le!=U&&(f.globalAlpha=Le=U),Rn("drawSeries",I)}}),x&&(f.globalAlpha=Le=1)}}function en(x,M){let I=M?v[x].points:v[x];I._stroke=I.stroke(i,x),I._fill=I.fill(i,x)}function Lt(x,M){let I=M?v[x].points:v[x],{stroke:U,fill:X,clip:Q,flags:le,_stroke:pe=I._stroke,_fill:Se=I._fill,_width:Ue=I.width}=I._paths;Ue=Ht(Ue*Rt,3);let Fe=null,Be=Ue%2/2;M&&Se==null&&(Se=Ue>0?"#fff":pe);let lt=I.pxAlign==1&&Be>0;if(lt&&f.translate(Be,Be),!M){let At=C-Ue/2,Tt=S-Ue/2,vt=q+Ue,et=he+Ue;Fe=new Path2D,Fe.rect(At,Tt,vt,et)}M?Oe(pe,Ue,I.dash,I.cap,Se,U,X,le,Q):Dt(x,pe,Ue,I.dash,I.cap,Se,U,X,le,Fe,Q),lt&&f.translate(-Be,-Be)}function Dt(x,M,I,U,X,Q,le,pe,Se,Ue,Fe){let Be=!1;Se!=0&&R.forEach((lt,At)=>{if(lt.series[0]==x){let Tt=v[lt.series[1]],vt=e[lt.series[1]],et=(Tt._paths||$a).band;ir(et)&&(et=lt.dir==1?et[0]:et[1]);let Xe,Yt=null;Tt.show&&et&&Ww(vt,ln,cn)?(Yt=lt.fill(i,At)||Q,Xe=Tt._paths.clip):et=null,Oe(M,I,U,X,Yt,le,pe,Se,Ue,Fe,Xe,et),Be=!0}}),Be||Oe(M,I,U,X,Q,le,pe,Se,Ue,Fe)}let yn=No|Hf;function Oe(x,M,I,U,X,Q,le,pe,Se,Ue,Fe,Be){Ae(x,M,I,U,X),(Se||Ue||Be)&&(f.save(),Se&&f.clip(Se),Ue&&f.clip(Ue)),Be?(pe&yn)==yn?(f.clip(Be),Fe&&f.clip(Fe),St(X,le),fn(x,Q,M)):pe&Hf?(St(X,le),f.clip(Be),fn(x,Q,M)):pe&No&&(f.save(),f.clip(Be),Fe&&f.clip(Fe),St(X,le),f.restore(),fn(x,Q,M)):(St(X,le),fn(x,Q,M)),(Se||Ue||Be)&&f.restore()}function fn(x,M,I){I>0&&(M instanceof Map?M.forEach((U,X)=>{f.strokeStyle=Nr=X,f.stroke(U)}):M!=null&&x&&f.stroke(M))}function St(x,M){M instanceof Map?M.forEach((I,U)=>{f.fillStyle=Ns=U,f.fill(I)}):M!=null&&x&&f.fill(M)}function ds(x,M,I,U){let X=A[x],Q;if(U<=0)Q=[0,0];else{let le=X._space=X.space(i,x,M,I,U),pe=X._incrs=X.incrs(i,x,M,I,U,le);Q=uE(M,I,pe,U,le)}return X._found=Q}function dn(x,M,I,U,X,Q,le,pe,Se,Ue){let Fe=le%2/2;y==1&&f.translate(Fe,Fe),Ae(pe,le,Se,Ue,pe),f.beginPath();let Be,lt,At,Tt,vt=X+(U==0||U==3?-Q:Q);I==0?(lt=X,Tt=vt):(Be=X,At=vt);for(let et=0;et<x.length;et++)M[et]!=null&&(I==0?Be=At=x[et]:lt=Tt=x[et],f.moveTo(Be,lt),f.lineTo(At,Tt));f.stroke(),y==1&&f.translate(-Fe,-Fe)}function Fr(x){let M=!0;return A.forEach((I,U)=>{if(!I.show)return;let X=b[I.scale];if(X.min==null){I._show&&(M=!1,I._show=!1,pt(!1));return}else I._show||(M=!1,I._show=!0,pt(!1));let Q=I.side,le=Q%2,{min:pe,max:Se}=X,[Ue,Fe]=ds(U,pe,Se,le==0?z:Pe);if(Fe==0)return;let Be=X.distr==2,lt=I._splits=I.splits(i,U,pe,Se,Ue,Fe,Be),At=X.distr==2?lt.map(Xe=>si[Xe]):lt,Tt=X.distr==2?si[lt[1]]-si[lt[0]]:Ue,vt=I._values=I.values(i,I.filter(i,At,U,Fe,Tt),U,Fe,Tt);I._rotate=Q==2?I.rotate(i,vt,U,Fe):0;let et=I._size;I._size=Ei(I.size(i,vt,U,x)),et!=null&&I._size!=et&&(M=!1)}),M}function $i(x){let M=!0;return Vo.forEach((I,U)=>{let X=I(i,U,Hi,x);X!=Ai[U]&&(M=!1),Ai[U]=X}),M}function ps(){for(let x=0;x<A.length;x++){let M=A[x];if(!M.show||!M._show)continue;let I=M.side,U=I%2,X,Q,le=M.stroke(i,x),pe=I==0||I==3?-1:1,[Se,Ue]=M._found;if(M.label!=null){let Yn=M.labelGap*pe,ai=wn((M._lpos+Yn)*Rt);De(M.labelFont[0],le,"center",I==2?"top":mg),f.save(),U==1?(X=Q=0,f.translate(ai,wn(S+he/2)),f.rotate((I==3?-yh:yh)/2)):(X=wn(C+q/2),Q=ai);let cr=s_(M.label)?M.label(i,x,Se,Ue):M.label;f.fillText(cr,X,Q),f.restore()}if(Ue==0)continue;let Fe=b[M.scale],Be=U==0?q:he,lt=U==0?C:S,At=M._splits,Tt=Fe.distr==2?At.map(Yn=>si[Yn]):At,vt=Fe.distr==2?si[At[1]]-si[At[0]]:Se,et=M.ticks,Xe=M.border,Yt=et.show?et.size:0,on=wn(Yt*Rt),Pn=wn((M.alignTo==2?M._size-Yt-M.gap:M.gap)*Rt),Ft=M._rotate*-yh/180,an=g(M._pos*Rt),ri=(on+Pn)*pe,qn=an+ri;Q=U==0?qn:0,X=U==1?qn:0;let _i=M.font[0],Ci=M.align==1?Co:M.align==2?Rf:Ft>0?Co:Ft<0?Rf:U==0?"center":I==3?Rf:Co,Yi=Ft||U==1?"middle":I==2?"top":mg;De(_i,le,Ci,Yi);let oi=M.font[1]*M.lineGap,xi=At.map(Yn=>g(a(Yn,Fe,Be,lt))),Ri=M._values;for(let Yn=0;Yn<Ri.length;Yn++){let ai=Ri[Yn];if(ai!=null){U==0?X=xi[Yn]:Q=xi[Yn],ai=""+ai;let cr=ai.indexOf(`
`)==-1?[ai]:ai.split(/\n/gm);for(let Zn=0;Zn<cr.length;Zn++){let Fd=cr[Zn];Ft?(f.save(),f.translate(X,Q+Zn*oi),f.rotate(Ft),f.fillText(Fd,0,0),f.restore()):f.fillText(Fd,X,Q+Zn*oi)}}}et.show&&dn(xi,et.filter(i,Tt,x,Ue,vt),U,I,an,on,Ht(et.width*Rt,3),et.stroke(i,x),et.dash,et.cap);let Zi=M.grid;Zi.show&&dn(xi,Zi.filter(i,Tt,x,Ue,vt),U,U==0?2:1,U==0?S:C,U==0?he:q,Ht(Zi.width*Rt,3),Zi.stroke(i,x),Zi.dash,Zi.cap),Xe.show&&dn([an],[1],U==0?1:0,U==0?1:2,U==1?S:C,U==1?he:q,Ht(Xe.width*Rt,3),Xe.stroke(i,x),Xe.dash,Xe.cap)}Rn("drawAxes")}function pt(x){v.forEach((M,I)=>{I>0&&(M._paths=null,x&&(s==1?(M.min=null,M.max=null):M.facets.forEach(U=>{U.min=null,U.max=null})))})}let rn=!1,Xn=!1,Nt=[];function pn(){Xn=!1;for(let x=0;x<Nt.length;x++)Rn(...Nt[x]);Nt.length=0}function Bn(){rn||(sT(xd),rn=!0)}function Ka(x,M=!1){rn=!0,Xn=M,x(i),xd(),M&&Nt.length>0&&queueMicrotask(pn)}i.batch=Ka;function xd(){if(ae&&(_t(),ae=!1),ve&&(Te(),ve=!1),xe){if(jt(d,Co,Je),jt(d,"top",ht),jt(d,Va,z),jt(d,Ga,Pe),jt(p,Co,Je),jt(p,"top",ht),jt(p,Va,z),jt(p,Ga,Pe),jt(h,Va,nn),jt(h,Ga,un),u.width=wn(nn*Rt),u.height=wn(un*Rt),A.forEach(({_el:x,_show:M,_size:I,_pos:U,side:X})=>{if(x!=null)if(M){let Q=X===3||X===0?I:0,le=X%2==1;jt(x,le?"left":"top",U-Q),jt(x,le?"width":"height",I),jt(x,le?"top":"left",le?ht:Je),jt(x,le?"height":"width",le?Pe:z),Bf(x,Cr)}else pi(x,Cr)}),Nr=Ns=Ur=H=ee=J=K=Ee=w=null,Le=1,Xo(!0),Je!=we||ht!=kt||z!=Ge||Pe!=Ye){pt(!1);let x=z/Ge,M=Pe/Ye;if(ge&&!ie&&ue.left>=0){ue.left*=x,ue.top*=M,Or&&ls(Or,wn(ue.left),0,z,Pe),Br&&ls(Br,0,wn(ue.top),z,Pe);for(let I=0;I<ft.length;I++){let U=ft[I];U!=null&&($t[I]*=x,$n[I]*=M,ls(U,Ei($t[I]),Ei($n[I]),z,Pe))}}if(qt.show&&!re&&qt.left>=0&&qt.width>0){qt.left*=x,qt.width*=x,qt.top*=M,qt.height*=M;for(let I in Vh)jt(Vr,I,qt[I])}we=Je,kt=ht,Ge=z,Ye=Pe}Rn("setSize"),xe=!1}nn>0&&un>0&&(f.clearRect(0,0,u.width,u.height),Rn("drawClear"),T.forEach(x=>x()),Rn("draw")),qt.show&&re&&(Qa(qt),re=!1),ge&&ie&&(lr(null,!0,!1),ie=!1),fe.show&&fe.live&&me&&(kh(),me=!1),l||(l=!0,i.status=1,Rn("ready")),Ds=!1,rn=!1}i.redraw=(x,M)=>{ve=M||!1,x!==!1?Fs(E,L.min,L.max):Bn()};function Fh(x,M){let I=b[x];if(I.from==null){if(sn==0){let U=I.range(i,M.min,M.max,x);M.min=U[0],M.max=U[1]}if(M.min>M.max){let U=M.min;M.min=M.max,M.max=U}if(sn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;x==E&&I.distr==2&&sn>0&&(M.min=Vi(M.min,e[0]),M.max=Vi(M.max,e[0]),M.min==M.max&&M.max++),W[x]=M,ae=!0,Bn()}}i.setScale=Fh;let Oh,Bh,Or,Br,yd,vd,kr,zr,Sd,bd,Xt,Kt,Us=!1,On=ue.drag,An=On.x,Cn=On.y;ge&&(ue.x&&(Oh=Ti(Cw,p)),ue.y&&(Bh=Ti(Rw,p)),L.ori==0?(Or=Oh,Br=Bh):(Or=Bh,Br=Oh),Xt=ue.left,Kt=ue.top);let qt=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Vr=qt.show?Ti(Aw,qt.over?p:d):null;function Qa(x,M){if(qt.show){for(let I in x)qt[I]=x[I],I in Vh&&jt(Vr,I,x[I]);M!==!1&&Rn("setSelect")}}i.setSelect=Qa;function V0(x){if(v[x].show)te&&Bf(ct[x],Cr);else if(te&&pi(ct[x],Cr),ge){let I=Re?ft[0]:ft[x];I!=null&&ls(I,-10,-10,z,Pe)}}function Fs(x,M,I){Fh(x,{min:M,max:I})}function Xi(x,M,I,U){M.focus!=null&&X0(x),M.show!=null&&v.forEach((X,Q)=>{Q>0&&(x==Q||x==null)&&(X.show=M.show,V0(Q),s==2?(Fs(X.facets[0].scale,null,null),Fs(X.facets[1].scale,null,null)):Fs(X.scale,null,null),Bn())}),I!==!1&&Rn("setSeries",x,M),U&&qo("setSeries",i,x,M)}i.setSeries=Xi;function G0(x,M){_n(R[x],M)}function H0(x,M){x.fill=Mt(x.fill||null),x.dir=Et(x.dir,-1),M=M??R.length,R.splice(M,0,x)}function W0(x){x==null?R.length=0:R.splice(x,1)}i.addBand=H0,i.setBand=G0,i.delBand=W0;function $0(x,M){v[x].alpha=M,ge&&ft[x]!=null&&(ft[x].style.opacity=M),te&&ct[x]&&(ct[x].style.opacity=M)}let ms,Os,ar,Gr={focus:!0};function X0(x){if(x!=ar){let M=x==null,I=ke.alpha!=1;v.forEach((U,X)=>{if(s==1||X>0){let Q=M||X==0||X==x;U._focus=M?null:Q,I&&$0(X,Q?1:ke.alpha)}}),ar=x,I&&Bn()}}te&&nt&&wt(yg,Ce,x=>{ue._lock||(tt(x),ar!=null&&Xi(null,Gr,!0,mn.setSeries))});function qi(x,M,I){let U=b[M];I&&(x=x/Rt-(U.ori==1?ht:Je));let X=z;U.ori==1&&(X=Pe,x=X-x),U.dir==-1&&(x=X-x);let Q=U._min,le=U._max,pe=x/X,Se=Q+(le-Q)*pe,Ue=U.distr;return Ue==3?Io(10,Se):Ue==4?Xw(Se,U.asinh):Ue==100?U.bwd(Se):Se}function q0(x,M){let I=qi(x,E,M);return Vi(I,e[0],ln,cn)}i.valToIdx=x=>Vi(x,e[0]),i.posToIdx=q0,i.posToVal=qi,i.valToPos=(x,M,I)=>b[M].ori==0?r(x,b[M],I?q:z,I?C:0):o(x,b[M],I?he:Pe,I?S:0),i.setCursor=(x,M,I)=>{Xt=x.left,Kt=x.top,lr(null,M,I)};function Md(x,M){jt(Vr,Co,qt.left=x),jt(Vr,Va,qt.width=M)}function wd(x,M){jt(Vr,"top",qt.top=x),jt(Vr,Ga,qt.height=M)}let Wo=L.ori==0?Md:wd,$o=L.ori==1?Md:wd;function Y0(){if(te&&fe.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&dt)continue;let M=fe.values[x],I=0;for(let U in M)He[x][I++].firstChild.nodeValue=M[U]}}function kh(x,M){if(x!=null&&(x.idxs?x.idxs.forEach((I,U)=>{ne[U]=I}):jw(x.idx)||ne.fill(x.idx),fe.idx=ne[0]),te&&fe.live){for(let I=0;I<v.length;I++)(I>0||s==1&&!dt)&&Z0(I,ne[I]);Y0()}me=!1,M!==!1&&Rn("setLegend")}i.setLegend=kh;function Z0(x,M){let I=v[x],U=x==0&&D==2?si:e[x],X;dt?X=I.values(i,x,M)??at:(X=I.value(i,M==null?null:U[M],x,M),X=X==null?at:{_:X}),fe.values[x]=X}function lr(x,M,I){Sd=Xt,bd=Kt,[Xt,Kt]=ue.move(i,Xt,Kt),ue.left=Xt,ue.top=Kt,ge&&(Or&&ls(Or,wn(Xt),0,z,Pe),Br&&ls(Br,0,wn(Kt),z,Pe));let U,X=ln>cn;ms=Gt,Os=null;let Q=L.ori==0?z:Pe,le=L.ori==1?z:Pe;if(Xt<0||sn==0||X){U=ue.idx=null;for(let pe=0;pe<v.length;pe++){let Se=ft[pe];Se!=null&&ls(Se,-10,-10,z,Pe)}nt&&Xi(null,Gr,!0,x==null&&mn.setSeries),fe.live&&(ne.fill(U),me=!0)}else{let pe,Se,Ue;s==1&&(pe=L.ori==0?Xt:Kt,Se=qi(pe,E),U=ue.idx=Vi(Se,e[0],ln,cn),Ue=G(e[0][U],L,Q,0));let Fe=-10,Be=-10,lt=0,At=0,Tt=!0,vt="",et="";for(let Xe=s==2?1:0;Xe<v.length;Xe++){let Yt=v[Xe],on=ne[Xe],Pn=on==null?null:s==1?e[Xe][on]:e[Xe][1][on],Ft=ue.dataIdx(i,Xe,U,Se),an=Ft==null?null:s==1?e[Xe][Ft]:e[Xe][1][Ft];if(me=me||an!=Pn||Ft!=on,ne[Xe]=Ft,Xe>0&&Yt.show){let ri=Ft==null?-10:Ft==U?Ue:G(s==1?e[0][Ft]:e[Xe][0][Ft],L,Q,0),qn=an==null?-10:P(an,s==1?b[Yt.scale]:b[Yt.facets[1].scale],le,0);if(nt&&an!=null){let _i=L.ori==1?Xt:Kt,Ci=Tn(ke.dist(i,Xe,Ft,qn,_i));if(Ci<ms){let Yi=ke.bias;if(Yi!=0){let oi=qi(_i,Yt.scale),xi=an>=0?1:-1,Ri=oi>=0?1:-1;Ri==xi&&(Ri==1?Yi==1?an>=oi:an<=oi:Yi==1?an<=oi:an>=oi)&&(ms=Ci,Os=Xe)}else ms=Ci,Os=Xe}}if(me||Re){let _i,Ci;L.ori==0?(_i=ri,Ci=qn):(_i=qn,Ci=ri);let Yi,oi,xi,Ri,Zi,Yn,ai=!0,cr=ce.bbox;if(cr!=null){ai=!1;let Zn=cr(i,Xe);xi=Zn.left,Ri=Zn.top,Yi=Zn.width,oi=Zn.height}else xi=_i,Ri=Ci,Yi=oi=ce.size(i,Xe);if(Yn=ce.fill(i,Xe),Zi=ce.stroke(i,Xe),Re)Xe==Os&&ms<=ke.prox&&(Fe=xi,Be=Ri,lt=Yi,At=oi,Tt=ai,vt=Yn,et=Zi);else{let Zn=ft[Xe];Zn!=null&&($t[Xe]=xi,$n[Xe]=Ri,Eg(Zn,Yi,oi,ai),wg(Zn,Yn,Zi),ls(Zn,Ei(xi),Ei(Ri),z,Pe))}}}}if(Re){let Xe=ke.prox,Yt=ar==null?ms<=Xe:ms>Xe||Os!=ar;if(me||Yt){let on=ft[0];on!=null&&($t[0]=Fe,$n[0]=Be,Eg(on,lt,At,Tt),wg(on,vt,et),ls(on,Ei(Fe),Ei(Be),z,Pe))}}}if(qt.show&&Us)if(x!=null){let[pe,Se]=mn.scales,[Ue,Fe]=mn.match,[Be,lt]=x.cursor.sync.scales,At=x.cursor.drag;if(An=At._x,Cn=At._y,An||Cn){let{left:Tt,top:vt,width:et,height:Xe}=x.select,Yt=x.scales[Be].ori,on=x.posToVal,Pn,Ft,an,ri,qn,_i=pe!=null&&Ue(pe,Be),Ci=Se!=null&&Fe(Se,lt);_i&&An?(Yt==0?(Pn=Tt,Ft=et):(Pn=vt,Ft=Xe),an=b[pe],ri=G(on(Pn,Be),an,Q,0),qn=G(on(Pn+Ft,Be),an,Q,0),Wo(Gi(ri,qn),Tn(qn-ri))):Wo(0,Q),Ci&&Cn?(Yt==1?(Pn=Tt,Ft=et):(Pn=vt,Ft=Xe),an=b[Se],ri=P(on(Pn,lt),an,le,0),qn=P(on(Pn+Ft,lt),an,le,0),$o(Gi(ri,qn),Tn(qn-ri))):$o(0,le)}else Gh()}else{let pe=Tn(Sd-yd),Se=Tn(bd-vd);if(L.ori==1){let lt=pe;pe=Se,Se=lt}An=On.x&&pe>=On.dist,Cn=On.y&&Se>=On.dist;let Ue=On.uni;Ue!=null?An&&Cn&&(An=pe>=Ue,Cn=Se>=Ue,!An&&!Cn&&(Se>pe?Cn=!0:An=!0)):On.x&&On.y&&(An||Cn)&&(An=Cn=!0);let Fe,Be;An&&(L.ori==0?(Fe=kr,Be=Xt):(Fe=zr,Be=Kt),Wo(Gi(Fe,Be),Tn(Be-Fe)),Cn||$o(0,le)),Cn&&(L.ori==1?(Fe=kr,Be=Xt):(Fe=zr,Be=Kt),$o(Gi(Fe,Be),Tn(Be-Fe)),An||Wo(0,Q)),!An&&!Cn&&(Wo(0,0),$o(0,0))}if(On._x=An,On._y=Cn,x==null){if(I){if(Ud!=null){let[pe,Se]=mn.scales;mn.values[0]=pe!=null?qi(L.ori==0?Xt:Kt,pe):null,mn.values[1]=Se!=null?qi(L.ori==1?Xt:Kt,Se):null}qo(Pf,i,Xt,Kt,z,Pe,U)}if(nt){let pe=I&&mn.setSeries,Se=ke.prox;ar==null?ms<=Se&&Xi(Os,Gr,!0,pe):ms>Se?Xi(null,Gr,!0,pe):Os!=ar&&Xi(Os,Gr,!0,pe)}}me&&(fe.idx=U,kh()),M!==!1&&Rn("setCursor")}let Bs=null;Object.defineProperty(i,"rect",{get(){return Bs==null&&Xo(!1),Bs}});function Xo(x=!1){x?Bs=null:(Bs=p.getBoundingClientRect(),Rn("syncRect",Bs))}function Td(x,M,I,U,X,Q,le){ue._lock||Us&&x!=null&&x.movementX==0&&x.movementY==0||(zh(x,M,I,U,X,Q,le,!1,x!=null),x!=null?lr(null,!0,!0):lr(M,!0,!1))}function zh(x,M,I,U,X,Q,le,pe,Se){if(Bs==null&&Xo(!1),tt(x),x!=null)I=x.clientX-Bs.left,U=x.clientY-Bs.top;else{if(I<0||U<0){Xt=-10,Kt=-10;return}let[Ue,Fe]=mn.scales,Be=M.cursor.sync,[lt,At]=Be.values,[Tt,vt]=Be.scales,[et,Xe]=mn.match,Yt=M.axes[0].side%2==1,on=L.ori==0?z:Pe,Pn=L.ori==1?z:Pe,Ft=Yt?Q:X,an=Yt?X:Q,ri=Yt?U:I,qn=Yt?I:U;if(Tt!=null?I=et(Ue,Tt)?a(lt,b[Ue],on,0):-10:I=on*(ri/Ft),vt!=null?U=Xe(Fe,vt)?a(At,b[Fe],Pn,0):-10:U=Pn*(qn/an),L.ori==1){let _i=I;I=U,U=_i}}Se&&(M==null||M.cursor.event.type==Pf)&&((I<=1||I>=z-1)&&(I=Er(I,z)),(U<=1||U>=Pe-1)&&(U=Er(U,Pe))),pe?(yd=I,vd=U,[kr,zr]=ue.move(i,I,U)):(Xt=I,Kt=U)}let Vh={width:0,height:0,left:0,top:0};function Gh(){Qa(Vh,!1)}let Ed,Ad,Cd,Rd;function Pd(x,M,I,U,X,Q,le){Us=!0,An=Cn=On._x=On._y=!1,zh(x,M,I,U,X,Q,le,!0,!1),x!=null&&(wt(If,Ff,Id,!1),qo(_g,i,kr,zr,z,Pe,null));let{left:pe,top:Se,width:Ue,height:Fe}=qt;Ed=pe,Ad=Se,Cd=Ue,Rd=Fe}function Id(x,M,I,U,X,Q,le){Us=On._x=On._y=!1,zh(x,M,I,U,X,Q,le,!1,!0);let{left:pe,top:Se,width:Ue,height:Fe}=qt,Be=Ue>0||Fe>0,lt=Ed!=pe||Ad!=Se||Cd!=Ue||Rd!=Fe;if(Be&&lt&&Qa(qt),On.setScale&&Be&&lt){let At=pe,Tt=Ue,vt=Se,et=Fe;if(L.ori==1&&(At=Se,Tt=Fe,vt=pe,et=Ue),An&&Fs(E,qi(At,E),qi(At+Tt,E)),Cn)for(let Xe in b){let Yt=b[Xe];Xe!=E&&Yt.from==null&&Yt.min!=Gt&&Fs(Xe,qi(vt+et,Xe),qi(vt,Xe))}Gh()}else ue.lock&&(ue._lock=!ue._lock,lr(M,!0,x!=null));x!=null&&(xn(If,Ff),qo(If,i,Xt,Kt,z,Pe,null))}function j0(x,M,I,U,X,Q,le){if(ue._lock)return;tt(x);let pe=Us;if(Us){let Se=!0,Ue=!0,Fe=10,Be,lt;L.ori==0?(Be=An,lt=Cn):(Be=Cn,lt=An),Be&&lt&&(Se=Xt<=Fe||Xt>=z-Fe,Ue=Kt<=Fe||Kt>=Pe-Fe),Be&&Se&&(Xt=Xt<kr?0:z),lt&&Ue&&(Kt=Kt<zr?0:Pe),lr(null,!0,!0),Us=!1}Xt=-10,Kt=-10,ne.fill(null),lr(null,!0,!0),pe&&(Us=pe)}function Ld(x,M,I,U,X,Q,le){ue._lock||(tt(x),Ho(),Gh(),x!=null&&qo(vg,i,Xt,Kt,z,Pe,null))}function Dd(){A.forEach(fE),k(i.width,i.height,!0)}Rr(vh,Po,Dd);let Hr={};Hr.mousedown=Pd,Hr.mousemove=Td,Hr.mouseup=Id,Hr.dblclick=Ld,Hr.setSeries=(x,M,I,U)=>{let X=mn.match[2];I=X(i,M,I),I!=-1&&Xi(I,U,!0,!1)},ge&&(wt(_g,p,Pd),wt(Pf,p,Td),wt(xg,p,x=>{tt(x),Xo(!1)}),wt(yg,p,j0),wt(vg,p,Ld),Wf.add(i),i.syncRect=Xo);let el=i.hooks=n.hooks||{};function Rn(x,M,I){Xn?Nt.push([x,M,I]):x in el&&el[x].forEach(U=>{U.call(null,i,M,I)})}(n.plugins||[]).forEach(x=>{for(let M in x.hooks)el[M]=(el[M]||[]).concat(x.hooks[M])});let Nd=(x,M,I)=>I,mn=_n({key:null,setSeries:!1,filters:{pub:Ig,sub:Ig},scales:[E,v[1]?v[1].scale:null],match:[Lg,Lg,Nd],values:[null,null]},ue.sync);mn.match.length==2&&mn.match.push(Nd),ue.sync=mn;let Ud=mn.key,Hh=C_(Ud);function qo(x,M,I,U,X,Q,le){mn.filters.pub(x,M,I,U,X,Q,le)&&Hh.pub(x,M,I,U,X,Q,le)}Hh.sub(i);function J0(x,M,I,U,X,Q,le){mn.filters.sub(x,M,I,U,X,Q,le)&&Hr[x](null,M,I,U,X,Q,le)}i.pub=J0;function K0(){Hh.unsub(i),Wf.delete(i),En.clear(),kf(vh,Po,Dd),c.remove(),Ce?.remove(),Rn("destroy")}i.destroy=K0;function Wh(){Rn("init",n,e),Go(e||n.data,!1),W[E]?Fh(E,W[E]):Ho(),re=qt.show&&(qt.width>0||qt.height>0),ie=me=!0,k(n.width,n.height)}return v.forEach(Dr),A.forEach(us),t?t instanceof HTMLElement?(t.appendChild(c),Wh()):t(i,Wh):Wh(),i}Nn.assign=_n;Nn.fmtNum=Jf;Nn.rangeNum=Sh;Nn.rangeLog=wh;Nn.rangeAsinh=Zf;Nn.orient=Ir;Nn.pxRatio=Rt;Nn.join=iT;Nn.fmtDate=Qf,Nn.tzDate=pT;Nn.sync=C_;{Nn.addGap=jT,Nn.clipGaps=Ah;let n=Nn.paths={points:N_};n.linear=F_,n.stepped=QT,n.bars=eE,n.spline=nE}var od=16,dE=6,z_=6,Ih=class{constructor(){this.element=B("div",{class:"mark-labels","aria-hidden":"true"})}show(e,t,[i,s],r){let a=e.filter(u=>u.label&&t(u.at)>=i-1&&t(u.at)<=s+1).map(u=>({element:B("span",{class:"mark-label",text:u.label}),x:t(u.at)}));this.element.replaceChildren(...a.map(u=>u.element)),a.forEach(u=>{u.wide=Math.min(u.element.getBoundingClientRect().width,r)});let l=[];for(let u of a){u.from=Math.max(Math.min(u.x,r-u.wide),0);let f=l.findIndex(h=>h+dE<=u.from);u.row=f<0?l.length:f,l[u.row]=u.from+u.wide}let c=Math.min(l.length,z_);this.element.style.height=`${c*od}px`;for(let{element:u,row:f,from:h,x:d}of a){u.hidden=f>=z_,u.style.left=`${h.toFixed(1)}px`,u.style.top=`${(c-1-f)*od}px`;let p=B("span",{class:"mark-pole"});p.style.left=`${d.toFixed(1)}px`,p.style.top=`${(c-f)*od-2}px`,u.hidden||this.element.prepend(p)}}};var V_="12px system-ui, sans-serif",pE=[1,10,100,1e3,1e4,1e5].flatMap(n=>[1,2,5].map(e=>e*n));function Un({title:n,text:e,x:t,xLabel:i,yLabel:s,series:r,marks:o=()=>[],needle:a=()=>null,height:l=240,onClick:c,zero:u=!0,right:f=null,names:h=null,whole:d=!1}){let p=B("div",{class:"plot"}),y=B("ul",{class:"legend"}),g=o().some(O=>O.label)?new Ih:null,m=B("figure",{class:"curves"},B("figcaption",{text:n}),y,g?.element??[],B("div",{role:"img","aria-label":e},p)),v=B("div",{class:"needle",hidden:!0}),A=null,b=r,R=!0,E=!1,_=(O,N)=>({label:O,labelSize:22,size:N,font:V_,labelFont:V_,stroke:()=>Vt("muted"),grid:{stroke:()=>Vt("line"),width:1},ticks:{stroke:()=>Vt("line"),width:1}});function T(O){let N=b.map(j=>({label:j.label,stroke:()=>Vt(j.colour),width:j.dots||j.bars?0:j.width??2,dash:j.dash,paths:j.dots?()=>null:j.bars?Nn.paths.bars({size:[.6,9]}):void 0,fill:j.bars?()=>Vt(j.colour):void 0,spanGaps:!j.gaps,points:{show:!!j.dots,size:j.size??5,fill:()=>Vt(j.colour),stroke:()=>Vt(j.colour),width:0}}));return{width:O,height:l,padding:g?[5,null,null,null]:void 0,legend:{show:!1},cursor:{drag:{x:!0,y:!1},points:{show:!b.some(j=>j.dots)}},scales:{x:{time:!1,...h&&{range:[.5,h.length-1.5]},...d&&{range:(j,$,Z)=>[$-.5,Z+.5]}},y:{range:(j,$,Z)=>mE($,Z,u)}},axes:[{..._(i,34),...d&&{incrs:pE},...h&&{splits:()=>h.map((j,$)=>$).filter(j=>h[j]!==""),values:(j,$)=>$.map(Z=>h[Z])}},{..._(s,52),values:G_},...f?[{..._(f.label,64),side:1,grid:{show:!1},values:(j,$)=>G_(j,$.map(Z=>Number((Z*f.factor).toPrecision(2))))}]:[]],series:[{},...N],hooks:{drawAxes:[V],draw:[L,D],setScale:g?[F]:[],ready:g?[F]:[]}}}function V({ctx:O,bbox:N,valToPos:j}){for(let $ of o().filter(Z=>Z.shade)){let[Z,ne]=[$.at,$.to].map(fe=>Math.min(Math.max(j(fe,"x",!0),N.left),N.left+N.width));O.save(),O.fillStyle=Vt($.shade),O.fillRect(Z,N.top,ne-Z,N.height),O.restore()}}function F(O){let N=O.over.offsetLeft;g.show(o(),j=>N+O.valToPos(j,"x"),[N,N+O.over.clientWidth],p.clientWidth)}function L(O){let{ctx:N,bbox:j}=O;N.save();for(let $ of o().filter(Z=>Z.colour)){let Z=Math.round(O.valToPos($.at,"x",!0))+.5;Z<j.left||Z>j.left+j.width||(N.strokeStyle=Vt($.colour),N.setLineDash($.dash??[]),N.lineWidth=$.width??1,N.beginPath(),N.moveTo(Z,j.top),N.lineTo(Z,j.top+j.height),N.stroke())}N.restore()}function D(){let O=a(),N=O===null?NaN:A?.valToPos(O,"x")??NaN;v.hidden=!(N>=0&&N<=A.over.clientWidth),v.hidden||(v.style.transform=`translateX(${N.toFixed(1)}px)`)}function G(){let O=p.clientWidth;O!==0&&(A?.destroy(),A=new Nn(T(O),[t,...b.map(N=>N.values)],p),A.over.append(v),c&&A.over.addEventListener("click",()=>{A.cursor.idx!==null&&A.cursor.idx!==void 0&&c(t[A.cursor.idx],A.cursor.idx)}),y.replaceChildren(...b.filter(N=>N.label).map(N=>B("li",{},gE(N),N.label))))}let P=Yo(G),W=()=>{E=!R,R&&A?.redraw(!1)};return os(W),new IntersectionObserver(([O])=>{R=O.isIntersecting,R&&E&&W()}).observe(p),addEventListener("beforeprint",()=>{E&&A?.redraw(!1)}),new ResizeObserver(()=>{A&&A.width===p.clientWidth||P()}).observe(p),{element:m,follow:Yo(D),show(O){let N=O.length===b.length&&O.every((j,$)=>j.label===b[$].label);b=O,N?A?.setData([t,...b.map(j=>j.values)]):P()}}}var G_=(n,e)=>e.map(t=>String(Number(t.toPrecision(6))));function mE(n,e,t){if(!Number.isFinite(n)||!Number.isFinite(e))return[0,1];if(t&&n===0&&e===0)return[0,1];let[i,s]=t?[Math.min(n,0),Math.max(e,0)]:[n,e],r=Math.max((s-i)*.06,1e-6);return[t&&n>=0?0:i-r,t&&e<=0?0:s+r]}function gE(n){let e=B("span",{class:`swatch${n.dots?" dot":""}${n.dash?" dash":""}`,"aria-hidden":"true"});return e.style.setProperty("--swatch",`var(--${n.colour})`),e}var H_=240,_E=4e3;function W_(n){return Ze("curves","Errors and corrections","Curves",B("div",{class:"plots"},yE(n),vE(n),SE(n),bE(n)))}function xE({course:n,correction:e}){let t=Array.from({length:H_+1},(s,r)=>n.end*r/H_),i=e.buckets.slice(1).flatMap(s=>[s.from_min-1e-6,s.from_min]);return[...new Set([...t,...i.filter(s=>s<n.end)])].sort((s,r)=>s-r)}var $_=n=>n.byTemperature?"degrees Celsius":"warm-up minute";function yE(n){let{course:e,correction:t,data:i,view:s,state:r}=n,o=xE(n),a=kd(e,t,o),l=a.after??o.map(()=>i.worst_after_mm),c=s.claims?.points??[],u=o.map(d=>null);for(let[d,p]of c){let y=o.reduce((g,m,v)=>Math.abs(m-d)<Math.abs(o[g]-d)?v:g,0);u[y]=p}let f=()=>{let d=r.point,p=d===null?[]:[{label:"chosen target",colour:"before",dash:[5,4],width:1.5,values:o.map(y=>yi(e.error(d,e.at(y))))},t.inBuckets&&{label:"chosen target, corrected",colour:"after",dash:[5,4],width:1.5,values:o.map(y=>yi(e.error(d,t.leftShares(y))))}].filter(Boolean);return[{label:"worst target, uncorrected",colour:"before",values:a.before},{label:a.after?"worst target, corrected":"corrected, at worst over all minutes",colour:"after",values:l},...p,...c.length>0?[{label:s.claims.text,colour:"claim",dots:!0,size:8,values:u}]:[]]},h=Un({title:"Error of the TCP over the warm-up",x:o.map(d=>d+e.from),xLabel:$_(e),yLabel:"mm",text:`Worst error uncorrected up to ${de(i.worst_before_mm)} mm, corrected up to ${de(i.worst_after_mm)} mm`,series:f(),needle:()=>r.t+e.from,onClick:d=>r.set({t:Math.round(d-e.from)}),height:280});return r.on("t",h.follow),r.on("point",()=>h.show(f())),h.element}function vE({course:n,correction:e,state:t,data:i}){let s=n.t,r=n.count>0?t.point??0:0,o=yi(n.error(r,n.at(n.end)))||1,a=n.nodes===1?n.shares[0]:s.map(u=>yi(n.error(r,n.at(u)))/o),l=e.buckets.slice(1).map(u=>u.from_min+n.from),c=Un({title:e.inBuckets?`Share of the drift, and the ${e.buckets.length} buckets`:"Share of the drift",x:s.map(u=>u+n.from),xLabel:$_(n),yLabel:"share",text:`The share of the settled drift over the warm-up${e.inBuckets?` and the borders of ${e.buckets.length} buckets`:""}`,series:[{label:"share that has come",colour:"text",values:a},...l.length?[{label:"border of two buckets",colour:"bucket",values:s.map(()=>null),dash:[3,3]}]:[]],marks:()=>l.map(u=>({at:u,colour:"bucket",dash:[3,3]})),needle:()=>t.t+n.from,onClick:u=>t.set({t:Math.round(u-n.from)}),height:280});return t.on("t",c.follow),c.element}function X_(n){let e=Math.max(Math.ceil(n.count/_E),1);return Array.from({length:Math.ceil(n.count/e)},(t,i)=>i*e)}function SE({course:n,motions:e,state:t,data:i}){let s=X_(n),r=l=>e.get(n.points.motion[l]),o=s.length<=400,a=Un({title:"Correction of each target, in the order of the program",x:s.map(l=>l+1),xLabel:"target",whole:!0,yLabel:"mm",text:`Corrections of ${s.length} targets`,series:[{label:"largest correction",colour:"before",dots:o,values:s.map(l=>r(l)?.max_correction_mm??null)},{label:"error left at worst",colour:"after",dots:o,values:s.map(l=>r(l)?.after_mm??null)},{label:"path, off between targets",colour:"claim",dots:o,values:s.map(l=>r(l)?.mid_path_mm??null)}],needle:()=>t.point===null?null:t.point+1,onClick:(l,c)=>t.set({point:s[c]})});return t.on("point",a.follow),a.element}function bE({course:n,state:e,motions:t}){let i=X_(n),s=Un({title:"Joints at the targets",x:i.map(r=>r+1),xLabel:"target",whole:!0,yLabel:"deg",zero:!1,text:`Nominal joints at ${i.length} targets`,series:[1,2,3,4,5,6].map(r=>({label:`J${r}`,colour:`joint-${r}`,width:1.5,dots:i.length===1,values:i.map(o=>n.points.q_deg[6*o+r-1])})),needle:()=>e.point===null?null:e.point+1,onClick:(r,o)=>e.set({point:i[o]})});return e.on("point",s.follow),s.element}var Lh=40;function tn({caption:n,columns:e,rows:t,onRow:i,name:s,sort:r,empty:o="nothing here",searchable:a=!0,rowClass:l}){let c=t,u=r??null,f=0,h=null,d=new Map,p="",y=new Array(t.length),g=new Map(t.map((O,N)=>[O,N])),m=O=>{let N=g.get(O);return y[N]??=e.map(j=>j.text(O)).join("").toLowerCase(),y[N]},v=B("tbody"),A=B("p",{class:"status",role:"status"}),b=Mi("Previous",()=>G(-1),{class:"small"}),R=Mi("Next",()=>G(1),{class:"small"}),E=e.map(O=>{let N=B("span",{class:"mark","aria-hidden":"true"}),j=B("th",{scope:"col",class:O.number?"number":""},B("button",{type:"button",class:"sort",onclick:()=>D(O)},O.label,N));return{column:O,heading:j,mark:N}});function _(O){return e.map((N,j)=>{let $=N.text(O),Z=j===0&&i?B("button",{type:"button",class:"link",text:$||Ot,onclick:()=>i(O)}):$;return B("td",{class:`${N.number?"number":""} ${N.class??""}`.trim(),title:String($).length>24?$:void 0},Z)})}function T(O){let N=d.get(O);N&&(N.classList.toggle("chosen",O===h),O===h?N.setAttribute("aria-current","true"):N.removeAttribute("aria-current"))}function V(O,N){d=new Map(c.slice(O,N).map(j=>[j,B("tr",{class:l?.(j)||void 0,onclick:i?$=>{$.target.tagName!=="BUTTON"&&i(j)}:void 0},_(j))])),v.replaceChildren(...d.values()),T(h),c.length===0&&v.append(B("tr",{},B("td",{colSpan:e.length,class:"empty",text:t.length?"no row matches":o})))}function F(){let O=Math.max(Math.ceil(c.length/Lh),1);f=Math.min(Math.max(f,0),O-1),V(f*Lh,(f+1)*Lh);let N=c.length===t.length?qe(t.length,"row"):`${Ie(c.length)} of ${qe(t.length,"row")}`;A.textContent=O>1?`${N}, page ${Ie(f+1)} of ${Ie(O)}`:N,b.disabled=f===0,R.disabled=f>=O-1,P.hidden=O<2;for(let{column:j,heading:$,mark:Z}of E){let ne=u?.key===j.key?u.up:null;$.setAttribute("aria-sort",ne===null?"none":ne?"ascending":"descending"),Z.textContent=ne===null?"":ne?" \u25B2":" \u25BC"}}function L(){c=p?t.filter(N=>m(N).includes(p)):[...t];let O=u&&e.find(N=>N.key===u.key);if(O){let N=c.map($=>[O.value($),$]),j=($,Z)=>$===Z?0:$==null?1:Z==null?-1:($<Z?-1:1)*(u.up?1:-1);N.sort(($,Z)=>j($[0],Z[0])),c=N.map(([,$])=>$)}F()}function D(O){let N=!O.number;u=u?.key===O.key?{key:O.key,up:!u.up}:{key:O.key,up:N},f=0,L()}function G(O){f+=O,F()}let P=B("div",{class:"pager"},b,R),W=a&&t.length>8?ka({label:`Search ${n.toLowerCase()}`,name:`${s}-search`,on:O=>{p=O.trim().toLowerCase(),f=0,L()}}):null;return W&&il(t.length,O=>m(t[O])),addEventListener("beforeprint",()=>{V(0,Tr),A.textContent=ph(c.length,t.length,"row")}),addEventListener("afterprint",F),L(),{element:B("div",{class:"table","data-name":s},B("div",{class:"bar"},W,A,P),B("div",{class:"scroll",tabIndex:0,role:"group","aria-label":n},B("table",{},B("caption",{class:"hidden",text:n}),B("thead",{},B("tr",{},E.map(O=>O.heading))),v))),choose(O){if(O===h)return;let N=h;h=O;let j=c.indexOf(O);j>=0&&!d.has(O)&&(f=Math.floor(j/Lh),F()),T(N),T(O)}}}var rr=n=>n==null?"":String(n),or=(n,e,t=4)=>({key:n,label:e,number:!0,value:i=>i[n],text:i=>de(i[n],t)}),q_=n=>{let e=t=>t.status==="compensated"?t:{};return{...n,value:t=>n.value(e(t)),text:t=>n.text(e(t))}};function Y_(n){let{data:e,view:t,course:i,state:s}=n,r=new Set(e.motions.map(h=>h.file)).size>1,o=[{key:"target",label:"target",value:h=>h.target??h.line,text:h=>Af(h),class:"name"},r&&{key:"file",label:"file",value:h=>h.file,text:h=>rr(h.file),class:"name"},{key:"line",label:"line",number:!0,value:h=>h.line,text:h=>rr(h.line)},{key:"routine",label:"routine",value:h=>h.routine,text:h=>rr(h.routine),class:"name"},{key:"kind",label:"move",value:h=>h.kind,text:h=>rr(h.kind)},{key:"status",label:"status",value:h=>h.status,text:h=>h.status==="compensated"?rr(h.form):`${h.status}: ${rr(h.reason)}`,class:"reason"},q_(or("max_correction_mm","correction mm")),q_(or("max_correction_deg","deg",5)),or("mid_path_mm","mid-path mm"),or("before_mm","before mm"),or("after_mm","after mm")].filter(Boolean),a={refused:0,kept:1,compensated:2},l=[...e.motions].sort((h,d)=>a[h.status]-a[d.status]),c=new Map;i?.points.motion.forEach((h,d)=>{c.has(h)||c.set(h,d)});let u=tn({caption:"Motions",name:"motions",columns:o,rows:l,empty:"the program has no motion",rowClass:h=>h.status,onRow:i?f:void 0});function f(h){let d=c.get(h.index);d!==void 0&&s.set({point:d}),u.choose(h)}return i&&s.on("point",()=>u.choose(n.motions.get(i.points.motion[s.point])??null)),Ze("motions","Motions","Motions",u.element,t.routines&&ME(t.routines))}function ME(n){let e=[{key:"routine",label:"routine",value:t=>t.routine,text:t=>rr(t.routine),class:"name"},{key:"file",label:"file",value:t=>t.file,text:t=>rr(t.file),class:"name"},{key:"motions",label:"motions",number:!0,value:t=>t.motions,text:t=>Ie(t.motions)},{key:"compensated",label:"compensated",number:!0,value:t=>t.compensated,text:t=>Ie(t.compensated)},or("max_correction_mm","largest correction mm"),or("before_mm","before mm"),or("after_mm","after mm")];return B("div",{},B("h3",{text:"All motions by routine"}),tn({caption:"Routines",name:"routines",columns:e,rows:n}).element)}var wE=.75;function Z_({data:n,view:e,version:t}){let i=n.errors.length>0,s=e.course&&e.points.motion.length>0?new sl(e):null,r=s&&new rl(s,n),o=s&&RE(s),a={data:n,view:e,course:s,correction:r,motions:new Map(n.motions.map(f=>[f.index,f])),state:Wr({t:s?Math.round(s.end*wE):0,times:20,point:o,corrected:!1,joints:s?.joints(o)??null})},l=e.totals??TE(n.motions),c=[()=>EE(n,e,l,i),()=>s&&dg(a),()=>s&&!i&&W_(a),()=>n.motions.length>0&&Y_(a),()=>e.source&&e.source.files.length>0&&lg(a),()=>Wn(CE(e),t)];return{kind:"compensation",verdict:i?"Refused: nothing was written":`${qe(l.motions,"motion")}: ${Ie(l.compensated)} compensated, ${Ie(l.kept)} kept`,tone:i?"bad":l.kept>0||n.warnings.length>0?"warn":"good",sections:c}}var TE=n=>{let e=t=>n.filter(i=>i.status===t).length;return{motions:n.length,compensated:e("compensated"),kept:e("kept"),refused:e("refused")}};function EE(n,e,t,i){let s=n.buckets.length,r=[i&&[B("h3",{text:"Refused"}),ei(n.errors,"bad")],n.warnings.length>0&&[B("h3",{text:qe(n.warnings.length,"warning")}),ei(n.warnings,"warn")],!i&&n.warnings.length===0&&B("p",{class:"calm",text:"No refusals, no warnings."})],o=(n.other_tolerances??[]).map(a=>`${a.tolerance_mm} mm ${a.buckets}`).join(", ");return Ze("overview","Overview","Overview",r,n.worst_before_mm!==null&&Hn(t.compensated>0&&[Qe("Worst error, uncorrected",de(n.worst_before_mm),"mm","any corrected target, any minute","before"),Qe("Worst error, corrected",de(n.worst_after_mm,n.worst_after_mm<5e-4?6:4),"mm","any corrected target, any minute","after")],Qe("Motions",Ie(t.motions),"",`${Ie(t.compensated)} compensated, ${Ie(t.kept)} kept, ${Ie(t.refused)} refused`),s>0?Qe("Buckets",Ie(s),"",o&&`at other tolerances: ${o}`):Qe("Form",AE(t),"","scaled at run time, no buckets"),t.compensated>0&&s>0&&Qe("Largest step between buckets",de(n.worst_switch_jump_mm),"mm","of the TCP"),t.compensated>0&&Qe("One work-object shift instead",de(n.rigid_shift_worst_mm),"mm","would be left at worst")),e.shown&&B("p",{class:"notice",text:`${Ie(t.motions)} motions are too many for one page: it holds ${Ie(e.shown)} of them: up to 10,000 that are kept or refused, and those with the largest corrections. Figures above and sums of routines are over all.`}),e.from_json&&B("p",{class:"notice",text:"Made from JSON alone: arm, curves and source are on the page that `compensate --report` writes."}))}function AE(n){return Object.entries(n.by_form??{}).filter(([,t])=>t>0).map(([t])=>t).join(", ")||Ot}var CE=n=>[...n.provenance??[],...n.settings??[]];function RE(n){let e=n.at(n.end),[t,i]=[null,-1];for(let s=0;s<n.count;s+=1){let r=Math.hypot(...n.error(s,e));r>i&&([t,i]=[s,r])}return t}var PE=99;function cs({label:n,rows:e,most:t}){let i=o=>Math.min(Math.max(o/t,0),1)*PE,s=o=>B("div",{class:"bar-row"},B("span",{class:"bar-name",text:o.label})," ",B("span",{class:"bar-value",text:o.text}),tl("svg",{width:"100%",height:12,"aria-hidden":"true"},tl("rect",{x:0,y:0,width:`${Math.max(i(o.value),.3)}%`,height:12,class:`bar-${o.colour??"plain"}`,rx:1.5}),o.interval?[tl("line",{x1:`${i(o.interval[0])}%`,x2:`${i(o.interval[1])}%`,y1:6,y2:6,class:"bar-interval"})]:[])),r=e.map(o=>`${o.label} ${o.text}`).join("; ");return B("div",{class:"bars",role:"img","aria-label":`${n}: ${r}`},e.map(s))}var j_=(n,e)=>Math.hypot(n[3*e],n[3*e+1],n[3*e+2]);function ad(n){let e=n.q_deg.length/n.line.length;return n.line.map((t,i)=>({i,line:t,id:n.id[i],t:n.t_min[i],outlier:n.outlier[i]===1,q:n.q_deg.slice(e*i,e*(i+1)),before:j_(n.before_mm,i),after:j_(n.after_mm,i)}))}function K_(n){let e=ad(n.view.residuals);n.rows=e;let t=e.filter(u=>!u.outlier),i=t.length>0&&t.every(u=>u.t!==null),{joint:s}=n.view.robot,r=s.map((u,f)=>f).filter(u=>new Set(t.map(f=>f.q[u])).size>1),o=[J_(t,{title:i?"Over time":"In the order of the rows",xLabel:i?"minutes":"line of the file",of:u=>i?u.t:u.line},n),...r.map(u=>{let f=s[u].type==="prismatic";return J_(t,{title:`By the ${f?"travel":"angle"} of joint ${u+1}`,xLabel:f?"mm":"deg",of:h=>h.q[u]},n)})],a=[{key:"line",label:"line",number:!0,value:u=>u.line,text:u=>String(u.line)},{key:"id",label:"id",value:u=>u.id,text:u=>u.id??"",class:"name"},i&&{key:"t",label:"min",number:!0,value:u=>u.t,text:u=>u.t===null?Ot:String(u.t)},{key:"before",label:"before mm",number:!0,value:u=>u.before,text:u=>de(u.before,3)},{key:"after",label:"after mm",number:!0,value:u=>u.after,text:u=>de(u.after,3)},{key:"outlier",label:"set aside",value:u=>u.outlier?1:0,text:u=>u.outlier?"false row":""}].filter(Boolean),l=tn({caption:"Rows",name:"rows",columns:a,rows:e,sort:{key:"before",up:!1},rowClass:u=>u.outlier?"refused":"",onRow:u=>n.state.set({row:u.i})});n.state.on("row",()=>l.choose(e[n.state.row]??null));let c=e.length<n.view.rows?B("p",{class:"notice",text:`Every ${Math.ceil(n.view.rows/e.length)}th of ${n.view.rows} rows is shown.`}):null;return Ze("residuals","Distance from the model, row by row","Residuals",B("div",{class:"plots three"},o.map(u=>u.element)),c,l.element)}function J_(n,{title:e,xLabel:t,of:i},{state:s}){let r=[...n].sort((a,l)=>i(a)-i(l)),o=Un({title:e,x:r.map(i),xLabel:t,yLabel:"mm",height:210,text:`${e}: distance from the model of ${n.length} rows before and after`,series:[{label:"before",colour:"before",dots:!0,size:4,values:r.map(a=>a.before)},{label:"after",colour:"after",dots:!0,size:4,values:r.map(a=>a.after)}],needle:()=>{let a=n.find(l=>l.i===s.row);return a?i(a):null},onClick:(a,l)=>s.set({row:r[l].i})});return s.on("row",o.follow),o}var cd=2e3,hd=200,Q_=n=>Math.round(cd**(n/hd)),IE=n=>Math.round(Math.log(n)/Math.log(cd)*hd);function e0(n){let{data:e,view:t,state:i}=n,s=t.residuals;n.rows??=ad(s);let r=uh(`Residuals of ${s.line.length} rows in the workspace and the arm in 3-D. Arrow keys with Shift turn it, plus and minus zoom, Home looks from the start again.`),o=n0(e,t,i),a=B("p",{class:"hud",role:"status"});if(!r)return Ze("workspace","In the workspace","Workspace",B("p",{class:"notice",text:"This browser draws no 3-D (WebGL is off)."}),o);let l=e.tool_mm??[0,0,0],c=new Mr(ol(t.robot),{thickness:ld(t.robot)/34,transparent:!0,opacity:.55,axes:!1}),u=new Eo(s.p_mm);u.path.visible=!1,r.scene.add(c.group,u.group),r.dressed(()=>{c.paint(Vt("arm"),Vt("arm-joint")),u.paint({path:Vt("path"),ring:Vt("accent")})});let f=n.rows.filter(y=>!y.outlier).map(y=>y.before).sort((y,g)=>y-g),h=Math.max(f[Math.floor(f.length*.95)]??0,1e-6);i.times=Math.min(Math.max(Math.round(ld(t.robot)*.08/h),10),cd);let d=r.beforePicture(()=>{let y=i.after?s.after_mm:s.before_mm;u.show((b,R)=>{for(let E=0;E<3;E+=1)R[E]=s.outlier[b]?0:y[3*b+E]},i.times,h),u.mark(i.row);let g=i.pose===null?null:e.next_measurements[i.pose],m=i.row===null?null:n.rows[i.row],v=g?.q_deg??m?.q??n.rows[0]?.q??t.robot.joint.map(()=>0),A=c.pose(v,l).map(b=>b.toFixed(1)).join(", ");a.textContent=g?`to measure next: pose ${i.pose+1}, point at ${A} mm`:m?`line ${m.line}: ${de(m.before,3)} mm before, ${de(m.after,3)} mm after, drawn at ${A} mm`:"",a.hidden=a.textContent===""});i.on("row after times pose",d),os(d),i.on("row",()=>{i.pose=null}),r.onPick(()=>u.dots,y=>i.set({row:y})),LE(r,s,ld(t.robot)),d(),r.canvas.windowPlace=y=>r.toWindow(s.p_mm.slice(3*y,3*y+3));let p=B("div",{class:"panel"},fh({label:"Residuals",name:"after",options:[["no","before"],["yes","after"]],value:"no",on:y=>i.set({after:y==="yes"})}),Ao({label:"Arrows enlarged",name:"times",min:0,max:hd,step:1,value:IE(i.times),show:y=>`${Q_(y)} \xD7`,on:y=>i.set({times:Q_(y)})}).element,B("p",{class:"calm",text:"Base and target are fitted in both; \u201Cafter\u201D has causes and background geometry taken off."}));return Ze("workspace","In the workspace","Workspace",B("div",{class:"stage"},B("div",{class:"screen"},r.element,a,B("p",{class:"scale"},B("span",{text:"0"}),B("span",{class:"ramp","aria-hidden":"true"}),B("span",{text:`${de(h,3)} mm`}))),p),o)}var ld=n=>[...n.joint,n.flange].reduce((e,{origin_mm:t})=>e+Math.hypot(...t),0);function LE(n,e,t){let i=[-.15*t,-.15*t,0],s=[.15*t,.15*t,.6*t];e.p_mm.forEach((r,o)=>{i[o%3]=Math.min(i[o%3],r),s[o%3]=Math.max(s[o%3],r)}),n.lookAt(i,s)}var t0=({data:n,view:e,state:t})=>n.next_measurements.length>0?Ze("next","What to measure next","Next",n0(n,e,t)):null;function n0(n,e,t){if(n.next_measurements.length===0)return null;let i=n.next_measurements.map((o,a)=>({...o,i:a})),s=[{key:"i",label:"pose",number:!0,value:o=>o.i,text:o=>String(o.i+1)},...i[0].q_deg.map((o,a)=>({key:`q${a}`,label:`J${a+1} ${e.robot?.joint[a].type==="prismatic"?"mm":"deg"}`,number:!0,value:l=>l.q_deg[a],text:l=>l.q_deg[a].toFixed(1)})),{key:"kg",label:"payload kg",number:!0,value:o=>o.payload_kg,text:o=>rt(o.payload_kg)},{key:"dir",label:`approach J1 to J${i[0].dir.length}`,value:o=>o.dir.join(),text:o=>o.dir.map(a=>a<0?"\u2212":"+").join(" ")}],r=tn({caption:"What to measure next",name:"next",columns:s,rows:i,searchable:!1,onRow:e.robot&&(o=>{r.choose(o),t.set({pose:o.i})})});return B("div",{},B("h3",{class:"apart",text:`What to measure next, ${n.next_reason}`}),r.element)}var DE={1:"eccentricity",2:"second harmonic"},NE=12,UE=12;function FE(n){let e=n.filter(i=>i.effect.startsWith("gear")&&i.size!==null&&i.slot!==null);return[...new Set(e.map(i=>i.joint))].sort((i,s)=>i-s).map(i=>({joint:i,lever_mm:null,lines:e.filter(s=>s.joint===i).map(s=>({n:s.n??(s.effect==="gear_eccentricity"?1:2),named:!0,mrad:1e3*s.size,sigma_mrad:s.sigma===null?null:1e3*s.sigma})).sort((s,r)=>s.n-r.n)}))}function i0(n,e){let t=(e.spectra??[]).length>0,i=t?e.spectra:FE(n.causes);if(i.length===0)return null;let s=i.flatMap(({joint:a,lever_mm:l,lines:c})=>c.map(u=>({joint:a,...u,mm:l===null?null:u.mrad*l/1e3}))),r=(a,l)=>`${a.toFixed(4)}${l===null?"":` \xB1 ${l.toFixed(4)}`}`,o=[{key:"joint",label:"joint",number:!0,value:a=>a.joint,text:a=>String(a.joint)},{key:"n",label:"lines a turn",number:!0,value:a=>a.n,text:a=>String(a.n)},{key:"mrad",label:"mrad",number:!0,value:a=>a.mrad,text:a=>r(a.mrad,a.sigma_mrad)},{key:"mm",label:"mm at the tool",number:!0,value:a=>a.mm,text:a=>de(a.mm)},{key:"named",label:"named",value:a=>a.named?1:0,text:a=>a.named?DE[a.n]??`${a.n} a turn`:""}];return Ze("gears","Gears: lines over a turn of each joint","Gears",B("div",{class:"plots"},i.map(OE)),B("p",{class:"notice","data-name":"gears-notice",text:t?"Amplitudes of the model. A joint with three named lines or more has every line that the model fits, up to 80 a turn, which spreads what the measured part of a turn cannot tell apart; others have their named lines and overtones of them. At the tool: times the distance of the measured points from the joint\u2019s axis, rms.":"Lines of the causes; the whole spectra and their size at the tool are on the page that `diagnose --report` writes."}),tn({caption:"Lines",name:"gear-lines",columns:o,rows:s,sort:{key:"mrad",up:!1},rowClass:a=>a.named?"":"quiet"}).element)}function OE({joint:n,lever_mm:e,lines:t}){let i=Math.max(...t.map(h=>h.n),NE),s=new Map(t.map(h=>[h.n,h])),r=[0,...Array.from({length:i},(h,d)=>d+1),i+1],o=h=>r.map(d=>s.get(d)?.named===h?s.get(d).mrad:null),a=t.filter(h=>h.named).sort((h,d)=>d.mrad-h.mrad),l=a.slice(0,UE).sort((h,d)=>h.n-d.n),c=t.length>a.length,[u]=[...t].sort((h,d)=>d.mrad-h.mrad),f=e===null?"":`, ${rt(u.mrad*e/1e3)} mm at the tool`;return Un({title:`Joint ${n}: ${t.length} ${t.length===1?"line":"lines"}, the largest ${u.n} a turn, ${rt(u.mrad)} mrad${f}`,x:r,xLabel:"lines a turn",yLabel:"mrad",height:230,right:e===null?null:{label:"mm at the tool",factor:e/1e3},text:`Gear of joint ${n}: ${a.map(h=>`${h.n} a turn ${h.mrad.toFixed(4)} mrad`).join(", ")}`,series:[{label:"named",colour:"after",bars:!0,values:o(!0)},...c?[{label:"of the spectrum beside them",colour:"bucket",bars:!0,values:o(!1)}]:[]],marks:()=>l.map(h=>({at:h.n,label:String(h.n)}))}).element}var BE={explained:["good","One cause, told apart from its rivals"],several:["good","Several causes, each needed"],ambiguous:["warn","A cause is there; these data cannot tell which of a set"],geometry:["good","Small errors of all joints, none singled out"],unexplained_structure:["warn","Structure that no effect of the library takes"],unexplained_scatter:["warn","More scatter than the repeats allow"],nothing_above_noise:["good","Nothing above the noise"],insufficient_data:["bad","Too few or too alike poses for any answer"],data_fault:["bad","The file contradicts itself or the robot"]},kE=new Set(["explained","several","ambiguous","data_fault"]),fd=n=>n.replaceAll("_"," ");function Lr(n){let e=n.joint?` of joint ${n.joint}`:"",t=n.joint_b?` on joint ${n.joint_b}`:"",i=n.n&&n.effect==="gear_mesh"?`, ${n.n} per turn`:"",s=n.t0_min!==null&&n.t0_min!==void 0?` at minute ${rt(n.t0_min)}`:"";return`${fd(n.effect)}${e}${t}${i}${s}`}var s0=n=>n>.999?"> 99.9 %":n<.001?"< 0.1 %":`${(100*n).toFixed(1)} %`,zE=n=>n.size===null?Ot:`${n.sigma===null?rt(n.size):Bd(n.size,n.sigma)} ${n.unit==="1"?"":n.unit}`;function r0({data:n,view:e,version:t}){let[i,s]=BE[n.verdict]??["",fd(n.verdict)],r={data:n,view:e,state:Wr({row:null,pose:null,after:!1,times:100})},o=(e.residuals?.line.length??0)>0;return{kind:"diagnosis",verdict:s,tone:i,sections:[()=>VE(n,e,i),()=>HE(n),()=>i0(n,e),()=>o&&K_(r),()=>e.robot&&(o||n.next_measurements.length>0)&&e0(r),()=>!e.robot&&t0(r),()=>n.false_rows?.length>0&&YE(n),()=>ZE(n),()=>Wn([...e.provenance??[],...e.robot?[["robot",e.robot.name]]:[]],t)]}}function VE(n,e,t){let{shrink:i,noise:s}=n,r=[{label:"before",value:i.before_rms_mm,text:`${de(i.before_rms_mm,3)} mm`,colour:"before"},i.causes_only_rms_mm!==null&&{label:"causes alone",value:i.causes_only_rms_mm,text:`${de(i.causes_only_rms_mm,3)} mm`,colour:"plain"},{label:"with the model",value:i.after_rms_mm,text:`${de(i.after_rms_mm,3)} mm`,colour:"after",interval:i.ci90&&i.ci90.map(l=>l*i.before_rms_mm)},{label:"noise",value:i.floor_rms_mm,text:`${de(i.floor_rms_mm,3)} mm`,colour:"plain"}].filter(Boolean),o=[["last part of the time",i.time_block],["a region of the workspace",i.region_block]].filter(([,l])=>l),a=Math.max(...r.map(l=>l.interval?.[1]??0),...r.map(l=>l.value));return Ze("overview","Verdict","Verdict",B("p",{class:`reason ${t}`,text:GE(n.reason)}),e.mostly&&B("p",{class:"notice","data-name":"mostly",text:e.mostly}),e.next&&B("p",{class:"next","data-name":"next-step"},B("b",{text:"Next: "}),`${e.next}.`),e.from_json&&ki(n.notes),n.fault&&ei([{code:"data fault",message:typeof n.fault=="string"?n.fault:Object.values(n.fault).map(String).join("; ")}],"bad"),n.warnings.length>0&&ei(n.warnings,"warn"),Hn(Qe("Rows",Ie(n.rows),"",qe(n.stations,"station")),i.ratio!==null&&Qe(i.ratio>1?"The gap grows to":"The gap shrinks to",`${(100*i.ratio).toFixed(0)} %`,"",i.ci90&&`${(100*i.ci90[0]).toFixed(0)} to ${(100*i.ci90[1]).toFixed(0)} %, nine times in ten`,"after"),s?.repeats_sigma_mm!==void 0&&s.repeats_sigma_mm!==null&&Qe("Noise in repeats",de(s.repeats_sigma_mm),"mm","of one coordinate"),s?.shared_sigma_mm!==void 0&&s.shared_sigma_mm!==null&&Qe("Shared by the targets of a pose",de(s.shared_sigma_mm),"mm","where the arm stood: a pose tells once"),s?.model_sigma_mm!==void 0&&s.model_sigma_mm!==null&&Qe("Noise about the best model",de(s.model_sigma_mm),"mm",s.repeats_sigma_mm===null?"of one coordinate; nothing was repeated, so this cannot be checked":"of one coordinate"),n.where?.joint&&Qe("Where",`joint ${n.where.joint}`,"",n.where.time??void 0)),i.before_rms_mm!==null&&[B("h3",{class:"apart",text:"How much better the robot gets, on poses held out (rms, 3-D)"}),cs({label:"Error on held-out poses",rows:r,most:a})],o.map(([l,c])=>B("p",{class:"calm",text:`${l} held out whole: ${de(c.before_rms_mm,3)} mm before, ${de(c.after_rms_mm,3)} mm after`})),e.from_json&&B("p",{class:"notice",text:"Made from JSON alone: residuals and the arm are on the page that `diagnose --report` writes."}),wi(e))}var GE=n=>n?n[0].toUpperCase()+n.slice(1)+(n.endsWith(".")?"":"."):"";function HE(n){let e=kE.has(n.verdict),t=e?"Causes":"Nearest candidates, none of them the answer";if(n.causes.length===0)return Ze("causes","Causes","Causes",B("p",{class:"calm",text:"No cause is named."}));let i=[{key:"name",label:"effect",value:Lr,text:Lr,class:"name"},{key:"posterior",label:"probability",number:!0,value:s=>s.posterior,text:s=>s0(s.posterior)},{key:"size",label:"size",number:!0,value:s=>s.size,text:zE},{key:"rms",label:"tool moves, mm",number:!0,value:s=>s.rms_mm,text:s=>de(s.rms_mm,3)},{key:"seen",label:"of it seen, mm",number:!0,value:s=>s.rms_seen_mm,text:s=>de(s.rms_seen_mm,3)},{key:"evidence",label:"evidence, nats",number:!0,value:s=>s.evidence_nats,text:s=>s.evidence_nats===null?Ot:s.evidence_nats.toFixed(1)},{key:"usual",label:"usual",value:s=>s.usual,text:s=>s.usual??"",class:"name"},{key:"source",label:"source",value:s=>s.source,text:s=>s.source??"",class:"reason"}];return Ze("causes",t,"Causes",WE(n.causes,e),tn({caption:"Causes",name:"causes",columns:i,rows:n.causes,searchable:!1}).element,n.zeros_alone&&B("p",{class:"notice","data-name":"zeros",text:XE(n)}),B("p",{class:"notice",text:"Seen: what is left of it where base and target, which are fitted, stand as well as they can beside it."}),n.rivals?.length>0&&[B("h3",{class:"apart",text:"What it is not, as far as these data tell"}),tn({caption:"Rivals",name:"rivals",columns:i.filter($E(n.rivals)),rows:n.rivals}).element])}var ud=12;function WE(n,e){let t=[...new Set(n.map(l=>l.slot))].map(l=>n.filter(c=>c.slot===l)),i=t.filter(l=>l.length===1).flat(),s=t.filter(l=>l.length>1),r=(l,c)=>[l&&B("h3",{class:"apart",text:l}),cs({label:"Probability",most:1,rows:c.slice(0,ud).map(u=>({label:qE(u),value:u.posterior,text:s0(u.posterior),colour:"after"}))}),c.length>ud&&B("p",{class:"notice",text:`and ${c.length-ud} more in the table`})],o=t.length>1?e?"Each is there, beside the others":"Each beside the others":null,a=l=>`One of ${l} that these data ${e?"cannot tell apart":"leave open"}`;return[i.length>0&&r(o,i),...s.map(l=>r(a(l.length),l))]}var $E=n=>e=>n.some(t=>(e.value(t)??null)!==null);function XE({zeros_alone:n,causes:e}){let t=s=>`${s<0?"\u2212":"+"}${Math.abs(180/Math.PI*s).toFixed(3)} deg`,i=e.some(s=>s.effect==="joint_offset")?"":"; beside geometry as wide as this arm's they are not told from it";return`Joint offsets alone would take the gap from ${de(n.before_rms_mm,3)} to ${de(n.after_rms_mm,3)} mm: ${n.joints.map(s=>`joint ${s.joint} ${t(s.offset_rad)}`).join(", ")}${i}.`}var qE=n=>Lr(n).replace(" of joint ",", J").replace("compliance","compl.").replace("eccentricity","ecc.").replace("second harmonic","2nd harm.");function YE(n){let e=[{key:"line",label:"line",number:!0,value:t=>t.line,text:t=>String(t.line)},{key:"id",label:"id",value:t=>t.id,text:t=>t.id??"",class:"name"},{key:"off",label:"off by, mm",number:!0,value:t=>t.off_mm,text:t=>de(t.off_mm,3)},{key:"like",label:"looks like",value:t=>t.looks_like,text:t=>t.looks_like??"",class:"reason"}];return Ze("false",`${qe(n.false_rows.length,"row")} set aside as false`,"False rows",tn({caption:"False rows",name:"false",columns:e,rows:n.false_rows}).element)}function ZE(n){let e=i=>`${fd(i.effect)}${i.joints.length?` of ${i.joints.length>1?"joints":"joint"} ${i.joints.join(", ")}`:""}`,t=[{key:"effect",label:"effect",value:Lr,text:Lr,class:"name"},{key:"size",label:"seen from",number:!0,value:i=>i.size,text:i=>`${rt(i.size)} ${i.unit}`}];return Ze("limits","What these data cannot tell","Limits",n.untestable_detail.length>0?B("dl",{class:"facts wide"},n.untestable_detail.map(i=>B("div",{},B("dt",{text:e(i)}),B("dd",{text:i.reason})))):B("p",{class:"calm",text:"Every effect of the library can be tested with them."}),n.detectable.length>0&&[B("h3",{class:"apart",text:"From which size on an effect would have been seen"}),tn({caption:"Detectable sizes",name:"detectable",columns:t,rows:n.detectable}).element])}var a0=n=>n.map((e,t)=>({i:t,line:e.line,point:e.point,t:e.t_min,before:Math.hypot(...e.before_mm),after:Math.hypot(...e.after_mm),of:e.after_mm,looksFalse:e.looks_false,counts:e.counts}));function l0(n,e,t){if(n.length===0)return[];let i=e.stops.map(([l,c])=>({at:l,to:c,shade:"shade",colour:"bucket",dash:[3,3],label:`stands ${rt(c-l)} min`})),s=e.points.map(l=>l.point),[r,o]=[n[0].t,n.at(-1).t],a=l=>s.indexOf(l.point)+1+.7*((l.t-r)/Math.max(o-r,1e-9)-.5);return[o0(n,t,{title:"Every touch over time",xLabel:"warm-up minute",x:l=>l.t,marks:()=>i}),o0(n,t,{title:"Every touch by point, in each from the first to the last",xLabel:"point",x:a,names:["",...s,""]})]}function o0(n,e,{title:t,xLabel:i,x:s,marks:r,names:o}){let a=[...n].sort((f,h)=>s(f)-s(h)),l=n.some(f=>f.looksFalse),c=f=>a.map(h=>f(h)??null),u=Un({title:t,x:a.map(s),xLabel:i,yLabel:"mm",height:240,marks:r,names:o,text:`${t}: ${n.length} touches, ${de(Math.max(...n.map(f=>f.before)),3)} mm at most before, ${de(Math.max(...n.map(f=>f.after)),3)} mm after; ${n.filter(f=>f.looksFalse).map(f=>`line ${f.line} looks false`).join(", ")}`,series:[{label:"moved since the cold arm",colour:"before",dots:!0,size:5,values:c(f=>f.before)},{label:"left by the fit",colour:"after",dots:!0,size:5,values:c(f=>f.looksFalse?null:f.after)},...l?[{label:"left, looks false",colour:"bad",dots:!0,size:10,values:c(f=>f.looksFalse?f.after:null)}]:[]],needle:()=>{let f=n.find(h=>h.i===e.row);return f?s(f):null},onClick:(f,h)=>e.set({row:a[h].i})});return e.on("row",u.follow),u.element}function c0(n,e){let i=tn({caption:"Touches",name:"touches",columns:[{key:"line",label:"line",number:!0,value:s=>s.line,text:s=>String(s.line)},{key:"point",label:"point",value:s=>s.point,text:s=>s.point,class:"name"},{key:"t",label:"min",number:!0,value:s=>s.t,text:s=>rt(s.t)},{key:"before",label:"moved mm",number:!0,value:s=>s.before,text:s=>de(s.before)},{key:"after",label:"left mm",number:!0,value:s=>s.after,text:s=>de(s.after)},{key:"of",label:"left x, y, z",value:s=>s.after,text:s=>s.of.map(r=>de(r,3)).join(", ")},{key:"false",label:"judged",value:s=>s.looksFalse?1:0,text:s=>s.looksFalse?`looks false${s.counts?"":", set aside"}`:""}],rows:n,sort:{key:"after",up:!1},rowClass:s=>s.looksFalse?"refused":"",onRow:s=>e.set({row:s.i})});return e.on("row",()=>i.choose(n[e.row]??null)),i.element}var jE={agrees:["The controller's own kinematics agree","good"],differs:["The controller's own kinematics do not agree","bad"],out_of_reach:["Agrees where it was asked; targets are out of reach","bad"],nothing_asked:["Nothing was asked","bad"],no_conclusion:["No conclusion: the controller calculates another flange than it shows","warn"],not_offered:["This controller does not calculate for others","warn"]},JE=n=>n?`${n.ours.join(", ")} here, ${n.controller.join(", ")} there`:null;function h0(n){let e=n.targets??[],[t,i]=[e.filter(o=>!o.agrees),o=>e.reduce((a,l)=>Math.max(a,l[o]??0),0)],s=o=>({at:o.at,element:o.element,agrees:o.agrees,"apart (mm)":o.apart_mm,"apart (deg)":o.apart_deg,"joints apart (deg)":o.joints_deg,reached:o.joints_deg!==null,"confdata that differ":JE(o.configurations),solutions:o.solutions?.count??null,"ours among them":o.solutions?.ours??null}),{controller:r={}}=n;return{kind:"targets put to a controller",verdict:jE[n.verdict]??[n.verdict,""],shown:["verdict","targets","out_of_reach","elements_out_of_reach","display_mm","not_known","robot","controller","host"],figures:[n.host&&["Controller",n.host,"",[r.robot,r.dialect].filter(Boolean).join(", ")],["Targets asked for",Ie(e.length),"",t.length>0?`${Ie(t.length)} do not agree`:"",t.length>0?"before":""],e.length>0&&["Worst",de(i("apart_mm")),"mm",`${i("apart_deg").toFixed(4)} deg, joints ${i("joints_deg").toFixed(4)} deg`],["Display and calculation",n.display_mm===void 0?Ot:de(n.display_mm),"mm","apart"],n.out_of_reach&&["Out of reach",Ie(n.out_of_reach.length),"",`motions${n.elements_out_of_reach?.length>0?`, and ${qe(n.elements_out_of_reach.length,"element")} of others`:""}, of ${n.robot}`],n.not_known!==void 0&&["Not asked for",Ie(n.not_known),"","motions whose targets only the running program knows"]].filter(Boolean),lists:[{key:"out_of_reach",title:"Motions whose targets are out of reach",short:"Out of reach",rows:(n.out_of_reach??[]).map(o=>({motion:o}))},{key:"elements_out_of_reach",title:"Elements of scheduled targets that are out of reach",short:"Elements",rows:(n.elements_out_of_reach??[]).map(o=>({motion:o.at,element:o.element}))},{key:"wrong",title:"Targets at which it does not agree",short:"Not agreeing",rows:t.map(s)},{key:"targets",title:"Every target that was asked for",short:"Targets",rows:e.map(s)}]}}function u0(n){let e=(n.free_memory?.rapid??[]).map(i=>({what:i.name,value:i.value,unit:i.unit})),t=n.free_memory?.disks??[];return{kind:"controller",verdict:[`${n.robot??"unknown robot"}, ${n.dialect??""}: ${n.mode}, motors ${n.motors}, RAPID ${n.execution}`,""],shown:["controller","virtual","system","robotware","dialect","robot","mode","motors","execution","absolute_accuracy","writer","free_memory","corrected","options","tasks"],figures:[["Controller",n.controller??Ot,"",n.virtual?"virtual":""],["System",n.system??Ot,"",`RobotWare ${n.robotware}`],["Robot",n.robot??Ot],["Mode",n.mode,"",`motors ${n.motors}, RAPID ${n.execution}`],["Absolute Accuracy",n.absolute_accuracy===!0?"ON":n.absolute_accuracy===!1?"off":"not known","","",n.absolute_accuracy?"before":""],["Right to write",n.writer?`held by ${typeof n.writer=="object"?Object.values(n.writer).filter(Boolean).join(", "):n.writer}`:"nobody holds it"]],lists:[{key:"corrected",title:"Corrected programs",short:"Corrected",rows:(n.corrected??[]).map(i=>({task:i.task,module:i.module,...i.values,"it said":i.said}))},{key:"tasks",title:"Tasks",rows:(n.tasks??[]).map(i=>({task:i.name,state:i.state,"moves an arm":i.moves,active:i.active,modules:i.modules.map(s=>s.name).join(", ")||"no module"}))},{key:"memory",title:"Memory of RAPID",short:"Memory",rows:e},{key:"disks",title:"Free on disk",short:"Disks",rows:t},{key:"options",title:"Options",rows:(n.options??[]).map(i=>({option:i}))}]}}var KE=n=>n.wrist_margin_deg===null?null:Math.min(n.wrist_margin_deg,n.elbow_margin_deg),f0=(n,e)=>n.map(t=>t===null?"9E9":t.toFixed(e)).join(", ");function QE(n,e){return[!n.same_frames&&"another instruction, tool or work object",n.buckets.length===0&&(n.asked?"asks the model for another target":n.settled_mm!==null?"by the model at run time":"only known at run time"),e?.same_configuration===!1&&"other confdata or external axes",e&&e.joint===null&&"out of the arm's reach",e?.same_branch===!1&&"another branch"].filter(Boolean).join(", ")}function d0(n,e,t){return{...t?{file:wr(n.file)}:{},line:n.line,"line after":n.line_after,routine:n.routine,move:n.kind,target:n.target,bucket:e?.index??null,"moved (mm)":e?.dp_mm??n.settled_mm,"turned (deg)":e?.angle_deg??n.settled_deg,joint:e?.joint??null,"joint by (deg)":e?.joint_deg??null,"to a limit (deg)":e?.limit_margin_deg??null,"to a singularity (deg)":e?KE(e):null,note:QE(n,e)}}var e1=n=>n?.position_mm?f0(n.position_mm,3):n?.joints_deg?f0(n.joints_deg,3):"";function p0(n){let e=o=>o.buckets.reduce((a,l)=>!a||l.dp_mm>a.dp_mm||l.dp_mm===a.dp_mm&&l.angle_deg>a.angle_deg?l:a,o.asked),t=new Set(n.motions.map(o=>o.file)).size>1,i=o=>({file:o.file,line:o.line,move:o.kind}),{worst:s}=n;return{kind:"comparison of two programs",verdict:n.same?["The same, byte for byte","good"]:n.same_elsewhere?["Every token that is not the target of a motion is the same in both","good"]:["Different beside the targets of motions","bad"],shown:["same","same_elsewhere","worst","motions","elsewhere","held_modes","only_before","only_after"],figures:[["Largest change of a TCP",de(s.dp_mm),"mm","","after"],["Largest turn of a TCP",s.angle_deg===null?Ot:s.angle_deg.toFixed(5),"deg"],["Largest change of a joint",s.joint_deg===null?Ot:s.joint_deg.toFixed(5),"deg"],["Largest step between buckets",de(s.bucket_step_mm),"mm"],["Nearest to a joint's limit",rt(s.limit_margin_deg),"deg"],["Nearest to a singularity",rt(s.singular_margin_deg),"deg","wrist or elbow"],["Configuration and branch",s.same_configuration?"the same":"NOT the same","",s.same_configuration?"everywhere":"see the notes of the rows"]],lists:[{key:"elsewhere",title:"What differs beside the targets",short:"Elsewhere",rows:[...n.elsewhere,...n.held_modes].map(o=>({difference:o}))},{key:"only_before",title:"Motions of the first program alone",short:"Only before",rows:n.only_before.map(i)},{key:"only_after",title:"Motions of the second program alone",short:"Only after",rows:n.only_after.map(i)},{key:"motions",title:"Motion by motion, each with its worst bucket",short:"Motions",rows:n.motions.map(o=>d0(o,e(o),t)),folded:[{key:"buckets",title:"Every bucket",rows:n.motions.filter(o=>o.buckets.length>1).flatMap(o=>o.buckets.map(a=>d0(o,a,t)))}]}]}}function m0(n){let e=n.motions.filter(r=>!r.can).length,t=new Set(n.motions.map(r=>r.file)).size>1,i=r=>r.targets.findLast(o=>o.position_mm||o.joints_deg),s=n.entries_of??n.entries.map(r=>({name:r}));return{kind:"what a program holds",verdict:n.notes?.[0]?[n.notes[0],e>0?"warn":"good"]:null,shown:["modules","entries","entries_of","motions","form","form_because"],figures:[["Motions",Ie(n.motions.length),"",qe(n.modules.length,"module")],["Can be compensated",Ie(n.motions.length-e),"","as far as the text tells","after"],["Stay as they are",Ie(e),"","",e>0?"before":""],["Form",n.form,"",n.form_because]],lists:[{key:"motions",title:"Motions",rows:n.motions.map(r=>({...t?{file:wr(r.file)}:{},line:r.line,routine:r.routine,move:r.kind,target:r.targets.map(o=>o.name??(o.position_mm||o.joints_deg?"[...]":"expression")).join(" "),tool:r.tool,"work object":r.wobj,"x, y, z mm or joints deg":e1(i(r)),"kept because":r.reason?`${r.reason} (${r.code})`:null}))},{key:"modules",title:"Modules",rows:n.modules.map(r=>({module:r.name,file:r.file,"already compensated":r.compensated}))},{key:"entries",title:"Routines that nobody calls",short:"Entries",rows:s.map(r=>({routine:r.name,module:r.module??null}))}]}}function g0(n){let e=n.cases.filter(i=>!i.same).length;return{kind:"cases against what is expected of them",verdict:e===0?[`${qe(n.cases.length,"case")}, all as expected`,"good"]:[`${Ie(e)} of ${qe(n.cases.length,"case")} differ${n.updated?": what is expected was updated":""}`,n.updated?"warn":"bad"],shown:["cases","updated"],figures:[["Cases",Ie(n.cases.length)],["Different",Ie(e),"",n.updated?"updated":""],["As expected",Ie(n.cases.length-e)]],lists:[{key:"cases",title:"Cases",rows:n.cases.map(i=>({case:i.case,"as expected":i.same,"files that differ":i.different_files?.join(", ")??null}))}]}}function _0(n){let e=n.files.filter(t=>!t.exact);return{kind:"restored originals",verdict:e.length===0?[`${qe(n.files.length,"file")}, byte for byte the original`,"good"]:[`${Ie(e.length)} of ${qe(n.files.length,"file")} not byte for byte the original`,"warn"],shown:[],figures:[],lists:[]}}var dd=6,Bo=n=>n.joint===null||n.joint===void 0?"":n.joint_b?`${n.joint} to ${n.joint_b}`:String(n.joint),x0=n=>`${n.effect.replaceAll("_"," ")} ${Bo(n)}`.trim(),y0=n=>`${rt(n.seen_from)}${Bo(n)&&` (${Bo(n)})`}`;function t1(n){return[...new Set(n.map(e=>e.effect))].map(e=>{let t=n.filter(r=>r.effect===e).sort((r,o)=>r.seen_from/r.usual-o.seen_from/o.usual),[i,s]=[t[0],t.at(-1)];return{effect:e.replaceAll("_"," "),of:t.length,usual:i.usual,unit:i.unit,"named from, best (joint)":y0(i),"named from, worst (joint)":t.length>1?y0(s):"","not at its usual size: joints":t.filter(r=>r.seen_from>r.usual).map(r=>Bo(r)||"all").join(", ")}})}var v0=n=>n.confounded.map(([e,t])=>`${e} for ${t}`),n1=n=>({joint:n.joint,"sigma (rad)":n.sigma,"named from (rad)":n.seen_from,"usual (rad)":n.usual,"told from all others":`${n.told_apart} of ${n.of}`,"most easily taken for another":n.confounded.length>dd?`${v0(n).slice(0,dd).join(", ")} and ${n.confounded.length-dd} more below`:v0(n).join(", ")}),i1=n=>({id:n.id,pose:n.pose_id??null,nest:n.nest??null,"joints (deg)":n.q_deg?.map(e=>e.toFixed(3)).join(", ")??null,"approach, joint by joint":n.dir?.map(e=>e>0?"+":e<0?"\u2212":"0").join(" ")??null,"payload (kg)":n.payload_kg??null});function S0(n){let e=n.confounded.filter(s=>!s.contained),t=n.steps.filter(s=>s.pose_id!==void 0),i=s=>({"true one":x0(s.a),"taken for":x0(s.b),"of its signal (%)":Number((100*s.r2).toFixed(1)),separation:s.separation});return{kind:"measurement plan",verdict:[`${qe(t.length,"measurement")} of ${qe(new Set(t.map(s=>s.pose_id)).size,"pose")}${t.length<n.steps.length?`, ${Ie(n.steps.length-t.length)} of nests`:""}`,""],shown:["steps","parameters","confounded","hidden","lines","exchanges"],figures:[["Measurements",Ie(t.length),"",qe(new Set(t.map(s=>s.pose_id)).size,"pose")],["Of nests",Ie(n.steps.length-t.length)],["Never seen",Ie(n.hidden.length),"","effects at their usual size"],["Stay confounded",Ie(e.length),"","pairs of effects at usual size"],["Exchanges",Ie(n.exchanges)]],lists:[{key:"expected",title:"Expected, each effect being the only cause beside the arm's tolerances",short:"Expected",rows:t1(n.parameters),notice:"Usual: of the joint that is told best.",folded:[{key:"parameters",title:"Every joint",rows:n.parameters.map(s=>({effect:s.effect.replaceAll("_"," "),joint:Bo(s),usual:s.usual,"named from":s.seen_from,sigma:s.sigma,unit:s.unit,"told at its usual size":s.seen_from<=s.usual}))}]},{key:"lines",title:"Lines of the gears",short:"Gears",rows:n.lines.map(n1),folded:[{key:"lines-confounded",title:"Lines that are taken for another",rows:n.lines.flatMap(s=>s.confounded.map(([r,o])=>({joint:s.joint,"line, a turn":r,"taken for":o})))}]},{key:"hidden",title:"Never seen at their usual size, inside base, target and the arm's tolerances",short:"Never seen",rows:n.hidden.map(s=>({effect:s.effect.replaceAll("_"," "),joint:Bo(s)}))},{key:"confounded",title:"Pairs that stay confounded at usual size",short:"Confounded",rows:e.map(i),folded:[{key:"contained",title:"Pairs beside, where the second has more parameters and contains the first: the simpler is named",rows:n.confounded.filter(s=>s.contained).map(i)}]},{key:"steps",title:"What to measure, in this order",short:"Steps",rows:n.steps.map(i1)}]}}var s1=n=>({"rms (mm)":n.rms_mm,"mean (mm)":n.mean_mm,"max (mm)":n.max_mm});function r1(n){let e=n.amount_held?`, held at the ${n.amount_held}`:"",t=a=>`\xB1 ${rt(Number(a?.toPrecision(2)))}`,i=n.tau_cool_min!==null,s=[...new Set(n.plan.flatMap(a=>a.intervals.map(l=>l.every_min)))],r=a=>({line:a.line,minute:a.t_min,point:a.point,"seen, share":a.seen,"off, sigmas":a.off_sigmas,"known, share":a.share,"known, \xB1":a.sigma,"smoothed, share":a.smoothed,"smoothed, \xB1":a.smoothed_sigma,outcome:a.outcome}),o=(a,l)=>a.intervals.find(c=>c.every_min===l)?.rms_mm??null;return{kind:"thermal state",verdict:n.drifts_otherwise?["This arm does not drift as the table says","bad"]:[`Drifts ${n.amount.toFixed(2)} \xB1 ${n.amount_sigma.toFixed(2)} times as far as the table, \u03C4 ${n.tau_min.toFixed(0)} min`,n.refused>0||n.amount_held?"warn":"good"],shown:["amount","amount_sigma","amount_held","drifts_otherwise","growth","refused","tau_min","tau_sigma_min","tau_cool_min","tau_cool_sigma_min","stops","touches","plan","false_first"],figures:[["Amount of drift",n.amount.toFixed(2),"",`\xB1 ${n.amount_sigma.toFixed(2)}, of the table's settled drift${e}`,"after"],["\u03C4",n.tau_min.toFixed(0),"min",t(n.tau_sigma_min)],["\u03C4 of cooling",i?n.tau_cool_min.toFixed(0):Ot,"min",i?t(n.tau_cool_sigma_min):"no stop was seen"],["Touches",Ie(n.touches.length),"",`${Ie(n.refused)} refused`],["Growth of the table",n.growth]],lists:[{key:"false_first",title:"First touches that are left out",short:"Left out",rows:n.false_first.map(a=>({line:a.line,point:a.point,"off (mm)":a.off_mm,"sigma along the drift (mm)":a.sigma_mm}))},{key:"refused",title:"Touches that were refused",short:"Refused",rows:n.touches.filter(a=>!a.taken).map(r)},{key:"stops",title:"When the robot stood",short:"Stops",rows:n.stops.map(([a,l])=>({"from (min)":a,"to (min)":l}))},{key:"plan",title:"How often to touch",short:"Plan",notice:"Left: what is left over a shift where the points drift most, one standard deviation, by the minutes between touches of that point.",rows:n.plan.map(a=>({point:a.point,"moves (mm)":a.settled_mm,...Object.fromEntries(s.map(l=>[`left, every ${rt(l)} min (mm)`,o(a,l)]))}))},{key:"touches",title:"Every touch",short:"Touches",notice:"Shares of the settled drift: seen by this touch alone, known from all touches so far, and smoothed by all of them; each with one standard deviation.",rows:n.touches.map(r)}]}}function o1(n){let e=[["all",n],["inside",n.inside],["outside",n.outside]].filter(([,i])=>i?.n>0),t=(n.notes??[]).find(i=>/^(NOT|WORSE)/.test(i));return{kind:"model put to measurements it has not seen",verdict:t?[t,"bad"]:[`${de(n.rms_mm)} mm rms with the model, ${de(n.nominal.rms_mm)} without`,n.rms_mm<n.nominal.rms_mm?"good":"bad"],shown:["n","rms_mm","mean_mm","max_mm","nominal","inside","outside","joints_outside","stops","worst"],figures:[["With the model",de(n.rms_mm),"mm",`rms; ${de(n.max_mm)} at worst`,"after"],["Nominal robot",de(n.nominal.rms_mm),"mm",`rms; ${de(n.nominal.max_mm)} at worst`,"before"],["Poses",Ie(n.n),"",n.outside?.n>0?`${Ie(n.outside.n)} outside of what the model was found in`:"all inside of what the model was found in"]],lists:[{key:"parts",title:"Inside and outside of the ranges that the model was found in",short:"Ranges",rows:e.map(([i,s])=>({poses:i,n:s.n,...Object.fromEntries([["model",s],["nominal",s.nominal]].flatMap(([r,o])=>Object.entries(s1(o)).map(([a,l])=>[`${r} ${a}`,l])))}))},{key:"joints_outside",title:"Joints that leave these ranges",short:"Joints",rows:n.joints_outside.map(([i,s])=>({joint:i,poses:s}))},{key:"stops",title:"When the robot stood",short:"Stops",rows:n.stops.map(([i,s])=>({"from (min)":i,"to (min)":s}))},{key:"worst",title:"Rows with most left",short:"Worst",rows:n.worst.map(i=>({line:i.line,"left (mm)":i.mm}))}]}}function a1(n){let e=n.minutes.at(-1);return{kind:"joints of targets over the warm-up",verdict:n.notes?.[1]?[n.notes[1],""]:null,shown:["rows","minutes","targets"],figures:[["Targets",Ie(n.targets.length)],["Minutes",Ie(n.minutes.length),"",e&&`to ${rt(e.t_min)}`],["Rows of the table",Ie(n.rows)]],lists:[{key:"minutes",title:"How far targets are missed, minute by minute",short:"Minutes",rows:n.minutes.map(t=>({minute:t.t_min,"before, max (mm)":t.before.max_mm,"before, rms (mm)":t.before.rms_mm,"before, max (deg)":t.before.max_deg,"after, max (mm)":t.after.max_mm,"after, rms (mm)":t.after.rms_mm,"after, max (deg)":t.after.max_deg}))},{key:"targets",title:"Targets",rows:n.targets.map(t=>({target:t.target,line:t.line,"joints (deg)":t.q_deg,confdata:t.confdata}))}]}}function l1(n){let e=n.measures.filter(i=>i.value!==null),t=e.filter(i=>i.judgement==="falls short");return{kind:"exam",verdict:e.some(i=>i.judgement)?[t.length>0?`Falls short in ${t.length} of ${qe(e.length,"measure")}`:`Passes all ${qe(e.length,"measure")} that were asked`,t.length>0?"bad":"good"]:null,shown:["measures"],figures:[["Sets",Ie(n.sets.length)],["Measures asked",Ie(e.length),"",`of ${Ie(n.measures.length)}`]],lists:[{key:"measures",title:"Measures",rows:n.measures.map(i=>({measure:i.name,value:i.value,"between, nine times in ten":i.ci90,sets:i.sets,"passes at":i.pass,"world-class at":i.world_class,"small is good":i.small_is_good,judged:i.judgement}))}]}}var c1=n=>({kind:"measurement sets of a virtual robot",verdict:[`${qe(n.sets,"set")} in ${n.out_dir}`,""],shown:[],figures:[],lists:[]}),b0={state:r1,plan:S0,validate:o1,tabulate:a1,exam:l1,synth:c1,diff:p0,inspect:m0,golden:g0,restore:_0,"link check":h0,"link info":u0};var h1=3,hs=n=>n.replaceAll("_"," ").replace(/ (mm|deg|min|kg)$/," ($1)"),Ls=n=>n!==null&&typeof n=="object"&&!Array.isArray(n),pd=n=>Array.isArray(n)&&n.length>h1&&n.every(Ls),u1={mm:4,deg:4,min:2,share:3,"\xB1":3,sigmas:1},f1=n=>u1[/[ _(](mm|deg|min|share|±|sigmas)\)?$/.exec(n)?.[1]];function ko(n,e){return n==null?Ot:typeof n=="number"?e===void 0?rt(n):n.toFixed(e):typeof n=="boolean"?n?"yes":"no":pd(n)?`${qe(n.length,"row")} below`:Array.isArray(n)?n.map(t=>ko(t,e)).join(", "):Ls(n)?Object.entries(n).map(([t,i])=>`${hs(t)} ${ko(i)}`).join("; "):String(n)}function Fn(n,e){let t=e.map(l=>Ls(l)?M0(l):{value:l}),i=l=>t.some(c=>Array.isArray(c[l])||Ls(c[l])),s=l=>t.some(c=>typeof c[l]=="string"&&c[l].length>40),r=[...new Set(t.flatMap(l=>Object.keys(l)))].filter(l=>t.some(c=>c[l]!==null&&c[l]!==void 0)),a=[...r.filter(l=>!i(l)),...r.filter(i)].map(l=>({key:l,label:hs(l),number:t.every(c=>c[l]===null||c[l]===void 0||typeof c[l]=="number"),class:s(l)?"reason":void 0,value:c=>Ls(c[l])||Array.isArray(c[l])?ko(c[l]):c[l],text:c=>ko(c[l],f1(l))}));return tn({caption:hs(n),name:n,columns:a,rows:t}).element}function M0(n){return Object.fromEntries(Object.entries(n).flatMap(([e,t])=>Ls(t)?Object.entries(t).map(([i,s])=>[`${e}_${i}`,s]):[[e,t]]))}function d1(n,e){let t=e.filter(Ls).map(M0);return[...new Set(t.flatMap(s=>Object.keys(s).filter(r=>pd(s[r]))))].map(s=>{let r=t.flatMap(o=>{let a=Object.entries(o).filter(([,l])=>l!==null&&typeof l!="object").slice(0,3);return Array.isArray(o[s])?o[s].map(l=>({...Object.fromEntries(a.map(([c,u])=>[`of_${c}`,u])),...l})):[]});return as(`${hs(n)}, ${hs(s)}: ${qe(r.length,"row")}`,()=>Fn(`${n}-${s}`,r),{printed:!0})})}var w0=(n,e,t,i,...s)=>Ze(`list-${n}`,`${e}: ${Ie(i.length)}`,t,Fn(n,i),d1(n,i),s);function p1({key:n,title:e,short:t,rows:i,notice:s,folded:r}){return i.length===0?null:w0(n,e,t??e,i,s&&B("p",{class:"notice",text:s}),(r??[]).filter(o=>o.rows.length>0).map(o=>as(`${o.title}: ${qe(o.rows.length,"row")}`,()=>Fn(o.key,o.rows))))}function T0({command:n,data:e,view:t,version:i}){let s=b0[n]?.(e),r=new Set(["notes","warnings",...s?.shown??[]]),o=Object.entries(e).filter(([p])=>!r.has(p)),a=o.filter(([,p])=>!Ls(p)&&!Array.isArray(p)),l=o.filter(([,p])=>Array.isArray(p)&&p.length>0),c=o.filter(([,p])=>Ls(p)),u=c.flatMap(([p,y])=>Object.entries(y).filter(([,g])=>pd(g)).map(([g,m])=>[`${p}_${g}`,m])),f=[Ze("overview","Overview","Overview",[...e.warnings??[],...t.messages??[]].length>0&&ei([...e.warnings??[],...t.messages??[]],"warn"),ki(e.notes),(s?.figures||a.length>0)&&Hn((s?.figures??[]).map(p=>Qe(...p)),a.map(([p,y])=>Qe(hs(p),ko(y)))),c.map(([p,y])=>[B("h3",{class:"apart",text:hs(p)}),wf(Object.entries(y).map(([g,m])=>[hs(g),ko(m)]))]),wi(t)),...(s?.lists??[]).map(p1),...[...l,...u].map(([p,y])=>w0(p,hs(p),hs(p),y)),Wn(t.provenance??[],i)].map(p=>()=>p),[h,d]=s?.verdict??[null,""];return{kind:s?.kind??n,verdict:h,tone:d,sections:f}}function m1(n){let[e,t]=n.split(":"),i=s=>s/Number(t);return{none:()=>1,exp:s=>1-Math.exp(-i(s)),"two-stage":s=>1-(1+i(s))*Math.exp(-i(s))}[e]??(()=>null)}var E0=n=>`${(100*n).toFixed(0)} %`,md=(n,e)=>e.toFixed(n.unit==="deg"?5:4);function g1(n){let e=i=>({key:i,label:i,number:!0,value:s=>s[i],text:s=>md(s,s[i])}),t=[{key:"joint",label:"joint",number:!0,value:i=>i.joint,text:i=>String(i.joint)},{key:"parameter",label:"parameter",value:i=>i.parameter,text:i=>i.parameter},e("value"),e("sigma"),{key:"unit",label:"unit",value:i=>i.unit,text:i=>i.unit},{key:"told",label:"told",number:!0,value:i=>i.told,text:i=>E0(i.told)}];return tn({caption:"Parameters",name:"parameters",columns:t,rows:n}).element}function A0({data:n,view:e,version:t}){let i=Number(n.growth.split(":")[1]??0),s=Array.from({length:121},(h,d)=>d*Math.max(i,10)*6/120),r=m1(n.growth),o=[...n.parameters].sort((h,d)=>d.told-h.told).filter(h=>h.told>=.2),a=n.targets,l=a0(n.residuals??[]),c=l.filter(h=>h.looksFalse),u=Wr({row:null}),f=[Ze("overview","Overview","Overview",n.warnings?.length>0&&ei(n.warnings,"warn"),Hn(Qe("Growth",n.growth.split(":")[0],"",`the other law has ${(100*n.other_law).toFixed(1)} %`),Qe("\u03C4",i.toFixed(1),"min",`\xB1 ${rt(n.tau_sigma_min)}`),Qe("\u03C4 of cooling",n.tau_cool_min===null?Ot:n.tau_cool_min.toFixed(1),"min",n.tau_cool_min===null?"no stop was seen":`\xB1 ${rt(n.tau_cool_sigma_min)}`),Qe("Touches",Ie(n.touches),"",`${qe(n.points.length,"point")}${c.length>0?`; ${Ie(c.length)} ${c.length===1?"looks":"look"} false`:""}`),Qe("Noise of one coordinate",de(n.sigma_mm),"mm"),a&&Qe("Drift at the targets",de(a.drift_rms_mm),"mm","rms, uncorrected","before"),a&&Qe("The table would leave",de(a.left_rms_mm),"mm",`rms; one shift of the work object ${de(a.shift_left_rms_mm)}`,"after")),ki(n.notes),wi(e)),Ze("curves","How it grows, and how far each point goes","Curves",B("div",{class:"plots"},Un({title:"Share of the settled deformation",x:s,xLabel:"warm-up minute",yLabel:"share",height:240,text:`${n.growth}`,series:[{label:`${n.growth.split(":")[0]}, \u03C4 ${i.toFixed(1)} min`,colour:"after",values:s.map(r)}],marks:()=>n.stops.flatMap(h=>h.map(d=>({at:d,colour:"bucket",dash:[3,3]})))}).element,...l0(l,n,u),B("div",{},B("h3",{text:"Settled shift of each point, by its own touches"}),cs({label:"Settled shift",most:Math.max(...n.points.map(h=>Math.hypot(...h.settled_mm)),1e-9),rows:n.points.map(h=>({label:h.point,value:Math.hypot(...h.settled_mm),text:`${de(Math.hypot(...h.settled_mm),3)} mm (${h.settled_mm.map(d=>de(d,3)).join(", ")})`,colour:"after"}))})))),l.length>0&&Ze("touches",`Every touch${c.length>0?`: ${qe(c.length,"touch").replace("touchs","touches")} of ${Ie(l.length)} ${c.length===1?"looks":"look"} false`:`: none of ${Ie(l.length)} looks false`}`,"Touches",B("p",{class:"notice",text:"Looks false: what the fit leaves of it is longer than five standard deviations, these from the middle one of all. It is set aside; where more than 15 % of the touches look false, all count: such an arm drifts in another way, or the tip is elsewhere."}),c0(l,u)),Ze("parameters",`What the touches tell: ${o.length} of ${n.parameters.length} parameters`,"Parameters",o.length>0&&cs({label:"Share that the data tell",most:1,rows:o.slice(0,16).map(h=>({label:`joint ${h.joint} ${h.parameter}: ${md(h,h.value)} \xB1 ${md(h,h.sigma)} ${h.unit}`,value:h.told,text:E0(h.told),colour:"after"}))}),g1(n.parameters)),a&&Ze("targets","At the targets","Targets",Fn("targets",a.each.map(h=>({target:h.target,"moves by (mm)":Math.hypot(...h.drift_mm),"known to (mm)":Math.hypot(...h.sigma_mm),"moves x, y, z (mm)":h.drift_mm,"sigma x, y, z (mm)":h.sigma_mm}))),a.next&&B("p",{class:"notice",text:`Touch next at joints ${a.next.q_deg.map(h=>h.toFixed(1)).join(", ")} deg (${a.next.at_mm.map(h=>h.toFixed(0)).join(", ")} mm): ${de(a.next.left_rms_mm)} mm would be left.`})),Wn(e.provenance??[],t)].map(h=>()=>h);return{kind:"fit of a warm-up",verdict:`${n.growth.split(":")[0]}, \u03C4 ${i.toFixed(1)} min`,tone:c.length>0?"warn":"good",sections:f}}var C0=(n,e)=>Object.entries(e).filter(([t])=>n[t]?.length>0).map(([t,i])=>Ze(`list-${t}`,`${i}: ${Ie(n[t].length)}`,i,Fn(t,n[t]))),qa=(n,e)=>Object.fromEntries(e.filter(t=>t in n).map(t=>[t,n[t]]));var _1=["effect","joint","posterior","size","sigma","unit","rms_mm","evidence_nats","source"],gd=n=>n.pose_id??n.id??`line ${n.line}`;function x1({verdict:n,within:e}){return n?{verdict:n,tone:e===!0?"good":"bad"}:n===void 0&&e===!1?{verdict:"NO GO: beyond a limit",tone:"bad"}:{verdict:n===null?"Measured; no limit was given":"No limit was exceeded",tone:""}}var P0=n=>[n.warnings?.length>0&&ei(n.warnings,"warn"),ki(n.notes)],R0=(n,e)=>e?Object.fromEntries(["a","b","c"].map((t,i)=>[`${n} ${t} (deg)`,e[i]])):{},y1=n=>({limit:n.limit,"at most (mm)":n.limit_mm,"worst (mm)":n.worst_mm,verdict:n.verdict,poses:n.poses,"poses needed":n.poses_needed}),v1=n=>n.poses.filter(e=>e.times?.length>1).flatMap(e=>e.times.map(t=>({pose:gd(e),minute:t.t_min,"AP (mm)":t.ap_mm,"RP (mm)":t.rp_mm})));function I0({data:n,view:e,version:t}){let{worst:i}=n,s=n.poses.map(l=>({pose:gd(l),line:l.line,"AP mm":l.ap_mm,"RP mm":l.repeatability?.rp_mm??null,n:l.repeatability?.n??1,"AP x (mm)":l.ap_xyz_mm?.[0]??null,"AP y (mm)":l.ap_xyz_mm?.[1]??null,"AP z (mm)":l.ap_xyz_mm?.[2]??null,"drift of AP mm":l.drift_ap_mm,"drift of RP mm":l.drift_rp_mm,...R0("AP",l.ap_abc_deg),...R0("RP",l.rp_abc_deg),joints:l.q_deg.map(c=>c.toFixed(1)).join(", ")})),r=v1(n),o=Math.max(...n.poses.map(l=>l.ap_mm),1e-9),a=[Ze("overview","Overview","Overview",Hn(Qe("Pose accuracy AP",de(i.ap_mm),"mm","the worst pose"),Qe("Repeatability RP",de(i.rp_mm),"mm","the worst pose"),Qe("Drift of AP",de(i.drift_ap_mm),"mm","the worst pose"),Qe("Poses",Ie(n.poses.length)),n.multi_directional_mm!==null&&Qe("Multi-directional",de(n.multi_directional_mm),"mm")),P0(n),n.lines_left_out?.length>0&&B("p",{class:"notice",text:`Not judged: ${qe(n.lines_left_out.length,"row")}, ${n.lines_left_out.length===1?"line":"lines"} ${n.lines_left_out.join(", ")}`}),n.limits?.length>0&&[B("h3",{class:"apart",text:"Limits"}),Fn("limits",n.limits.map(y1))],wi(e)),Ze("poses","Pose by pose","Poses",cs({label:"Pose accuracy",most:o,rows:[...n.poses].sort((l,c)=>c.ap_mm-l.ap_mm).slice(0,12).map(l=>({label:gd(l),value:l.ap_mm,text:`AP ${de(l.ap_mm)} mm${l.repeatability?`, RP ${de(l.repeatability.rp_mm)} mm`:""}`,colour:"after"}))}),Fn("poses",s)),r.length>0&&Ze("times","Over time, pose by pose","Times",Fn("times",r)),Wn(e.provenance??[],t)].map(l=>()=>l);return{kind:"ISO 9283",...x1(n),sections:a}}function L0({data:n,view:e,version:t}){let i=n.tools.map((r,o)=>({reflector:o+1,"moved by (mm)":Math.hypot(...r.by_mm),"x (mm)":r.by_mm[0],"y (mm)":r.by_mm[1],"z (mm)":r.by_mm[2],"sigma (mm)":r.sigma_mm})),s=[Ze("overview","Overview","Overview",Hn(Qe("The points have moved by",de(n.rms_mm),"mm",n.noise_rms_mm===null?"rms, base and tool refitted":`rms; noise alone would be ${de(n.noise_rms_mm)}`,"before"),Qe("Poses in both",Ie(n.pairs),"",`${n.alone[0]} only before, ${n.alone[1]} only after`),Qe("Base and instrument",de(Math.hypot(...n.base.by_mm),3),"mm",`${n.base.by_mm.map(r=>r.toFixed(3)).join(", ")}; turned by ${rt(n.base.turned_deg)} deg`),n.beyond_noise!==void 0&&Qe("Beyond the noise",Ie(n.beyond_noise),"","poses",n.beyond_noise>0?"before":"")),P0(n),wi(e)),i.length>0&&Ze("tools","The tool","Tool",Fn("tools",i)),n.causes.length>0&&Ze("causes","What has changed","Causes",cs({label:"Probability",most:1,rows:n.causes.slice(0,12).map(r=>({label:Lr(r),value:r.posterior,text:`${(100*r.posterior).toFixed(1)} %`,colour:"after"}))}),Fn("causes",n.causes.map(r=>qa(r,_1)))),n.worst.length>0&&Ze("worst","Poses that have moved most","Poses",Fn("worst",n.worst.map(r=>({"line before":r.line_before,"line after":r.line_after,"moved (mm)":r.mm})))),Wn(e.provenance??[],t)].map(r=>()=>r);return{kind:"comparison of two measurements",verdict:n.changed?"Changed":"Not changed",tone:n.changed?"warn":"good",sections:s}}function D0({data:n,view:e,version:t}){let{before:i,after:s}=n,r=Math.max(i.true_max_mm,s.true_max_mm),o=(u,f,h)=>({label:u,value:f,text:`${de(f)} mm`,colour:h}),a=[Ze("overview","Overview","Overview",B("p",{class:"reason",text:`Injected: ${n.withheld}.`}),ki(n.notes),Hn(Qe("Truly, before",de(i.true_rms_mm),"mm",`rms of ${qe(n.targets,"target")}; ${de(i.true_max_mm)} at worst`,"before"),Qe("Truly, after",de(s.true_rms_mm),"mm",`rms; ${de(s.true_max_mm)} at worst`,"after"),Qe("Noise floor",de(n.floor_rms_mm),"mm",n.limit_of_floor?`rms in space; ${rt(n.limit_of_floor)} times as much is allowed`:"rms in space"),n.kept>0&&Qe("Kept uncorrected",qe(n.kept,"motion"),"","","before"),Qe("Verdict",n.verdict.replaceAll("_"," "))),cs({label:"Errors before and after",most:r,rows:[o("before, at worst",i.true_max_mm,"before"),o("before, rms",i.true_rms_mm,"before"),o("after, at worst",s.true_max_mm,"after"),o("after, rms",s.true_rms_mm,"after"),o("noise of the measurement",n.floor_rms_mm,"plain")]}),wi(e)),n.causes.length>0&&Ze("causes","What was found","Causes",Fn("causes",n.causes.map(u=>typeof u=="string"?{cause:u}:u))),Wn(e.provenance??[],t)].map(u=>()=>u),l=n.within===void 0?"":`: ${n.within?"within":"NOT within"} ${rt(n.limit_of_floor)} times the noise floor`,c=s.true_rms_mm<i.true_rms_mm?"good":"warn";return{kind:"closed loop",verdict:`${de(i.true_rms_mm)} mm before, ${de(s.true_rms_mm)} mm after${l}`,tone:n.within===!1?"bad":c,sections:a}}var N0=n=>({...n,file:n.file?wr(n.file):n.file});function S1(n,e){let t=n.map(a=>a.t_min);if(!(e.length>0||t.some((a,l)=>l>0&&a<t[l-1])))return{x:t,label:"warm-up minute",values:a=>n.map(a)};let s=e.filter(a=>a.standing&&a.to_min>a.from_min).map(a=>({at:(a.from_min+a.to_min)/2,pass:null})),o=[...[0,Math.max(...n.map(a=>a.at_min),...e.map(a=>a.to_min))].map(a=>({at:a,pass:null})),...n.map(a=>({at:a.at_min,pass:a})),...s].sort((a,l)=>a.at-l.at);return{x:o.map(a=>a.at),label:"minutes since the beginning",values:a=>o.map(l=>l.pass?a(l.pass):null)}}function b1(n){let e=new Map;for(let t of n)e.set(t.from_min,[...e.get(t.from_min)??[],t]);return[...e].map(([t,i])=>{let s=i.find(r=>r.standing);return{at:t,label:i.map(r=>r.words).join(", "),colour:"bucket",dash:[3,3],to:s?.to_min,shade:s&&"shade"}})}function M1(n,e){let{x:t,label:i,values:s}=S1(n,e),r=n.length===1,o=b1(e),a=Math.max(...n.map(f=>f.after.max_mm??0)),l={x:t,xLabel:i,height:300,marks:()=>o},c=o.map(f=>`${f.label} at minute ${rt(f.at)}`).join(", "),u=(f,h,d)=>({label:f,colour:h,dots:r,gaps:!0,values:s(d)});return[Un({...l,title:"Worst error of the TCP",yLabel:"mm",text:`Worst error as executed ${de(a)} mm. ${c}`,series:[u("original","before",f=>f.before.max_mm),u("as executed","after",f=>f.after.max_mm),u("path between targets, as executed","claim",f=>f.path_after_mm)]}).element,e.length>0&&Un({...l,title:"How warm the robot is",yLabel:"warm-up minute",text:`Warm-up minute of the robot and of the program's clock. ${c}`,series:[u("the robot","before",f=>f.t_min),u("by the program's clock","after",f=>f.program_min)]}).element].filter(Boolean)}function U0({data:n,view:e,version:t}){let i=n.minutes,s=n.worst,r=i.map(h=>h.t_min),o=h=>i.reduce((d,p)=>Math.max(d,h(p)??0),0),a=i.length===1,l=n.marks??[],c=i.map(h=>({t_min:h.t_min,motions:h.n,"before max (mm)":h.before.max_mm,"before rms (mm)":h.before.rms_mm,"after max (mm)":h.after.max_mm,"after rms (mm)":h.after.rms_mm,"path (mm)":h.path_after_mm,unreached:h.unreached,failure:h.failure,mismatch:h.mismatch})),u=i.some(h=>h.failure||h.mismatch),f=[Ze("overview","Overview","Overview",Hn(Qe("Worst error of the original",de(o(h=>h.before.max_mm)),"mm","on the deformed robot","before"),Qe("Worst error as executed",de(o(h=>h.after.max_mm)),"mm",s&&`minute ${rt(s.t_min)}, ${wr(s.file)}:${s.line}`,"after"),Qe("Motions executed",Ie(n.executed.motions),"",`of ${Ie(n.executed.of)} in the program`),Qe(a?"Minute":"Passes",a?rt(r[0]):Ie(i.length)),n.switches.length>0&&Qe("Largest step at a switch",de(Math.max(...n.switches.map(h=>h.jump_mm))),"mm",qe(n.switches.length,"switch").replace("switchs","switches"))),ki(n.notes),wi(e)),i.length>0&&Ze("curves","Errors at each minute","Curves",B("div",{class:"plots"},M1(i,l)),l.length>0&&Fn("steps",l.map(h=>({step:h.words,"from (min)":h.from_min,"to (min)":h.to_min,"the robot stands":h.standing}))),Fn("passes",c)),...C0({...n,switches:n.switches.map(h=>qa(h,["t_min","jump_mm"])),functions:n.functions.map(h=>qa(h,["name","calls","statements","arithmetic","trigonometric"])),messages:n.messages.map(N0),unchanged:n.unchanged.map(N0)},{switches:"Switches",unchanged:"Motions not corrected",messages:"Messages",unknown_instructions:"Unknown instructions",functions:"Functions"}),Wn(e.provenance??[],t)].map(h=>()=>h);return{kind:"simulation",verdict:`${qe(n.executed.motions,"motion")} executed: ${de(o(h=>h.after.max_mm))} mm at worst`,tone:u||n.executed.motions===0?"bad":"good",sections:f}}var w1=4,Dh={tcMinute:["Warm-up minute","min"],tcDegrees:["Temperature","\xB0C"],tcBucket:["Bucket",""],tcShare:["Share of the drift",""],tcTouchSigma:["Known by touch to",""],tcTouchAge:["Touched","min ago"]};function T1(n,e){return n===-1?"follows the clock":n===-2?"originals":e&&n>=0&&n<=100?`held at ${rt(n)} %`:!e&&n>=0?`held at bucket ${rt(n)}`:"none that there is: originals"}var Ya=n=>typeof n=="number"?rt(n):String(n),F0=({values:n,said:e})=>n.tcBucket===-1||n.tcMode===-2||!!e?.includes("original targets");function O0({data:n,title:e,version:t}){let i=[...new Set(n.records.map(c=>`${c.task}/${c.module}`))],s=new Map(i.map(c=>[c,n.records.filter(u=>`${u.task}/${u.module}`===c)])),r=i.map(c=>s.get(c).at(-1)),o=[()=>Ze("now","Now","Now",E1(n),i.map(c=>A1(c,s.get(c).at(-1))),n.warnings.length>0&&[B("h3",{class:"apart",text:qe(n.warnings.length,"warning")}),ei([...n.warnings].reverse().map(c=>({code:`second ${rt(c.t_s)}`,message:c.text})),"warn")]),...i.map(c=>()=>C1(c,s.get(c))),()=>Wn([["controller",e],["looks",n.shown<n.seen?`${Ie(n.seen)}, of which ${Ie(n.shown)} are on this page: older ones are thinned out`:Ie(n.seen)]],t)],a=r.map(c=>F0(c)?"original targets":"corrected").join(", "),l=r.some(c=>c.said||F0(c))||n.warnings.length>0||n.ended;return{kind:"link watch",verdict:a||"nothing seen yet",tone:l?"warn":"good",sections:o}}function E1(n){let e=new Date(n.written_s*1e3),t=B("p",{class:"calm","data-name":"fresh",role:"status"}),i=new URLSearchParams(location.hash.slice(1));i.has("theme")&&vf(i.get("theme"));let s=!n.ended&&!i.has("hold"),r=()=>{let l=new URLSearchParams;document.documentElement.dataset.theme&&l.set("theme",document.documentElement.dataset.theme),!s&&!n.ended&&l.set("hold","1"),scrollY>0&&l.set("y",String(Math.round(scrollY))),history.replaceState(null,"",`#${l}`)};os(r);let o=()=>(Date.now()-e)/1e3,a=()=>{let l=`As of ${e.toLocaleString()}`;n.ended?t.textContent=`${l}. ${n.ended}`:o()>w1*n.every_s?t.textContent=`${l}: ${Math.round(o())} seconds old. Nothing new has been written since: the watch may have ended.`:t.textContent=`${l}; written anew every ${rt(n.every_s)} seconds.`};return a(),setInterval(a,1e3),setInterval(()=>{!s||document.hidden||(r(),location.reload())},n.every_s*1e3),i.has("y")&&addEventListener("page-whole",()=>scrollTo(0,Number(i.get("y"))),{once:!0}),[t,!n.ended&&Ba({label:`load the page anew every ${rt(n.every_s)} seconds`,name:"reload",value:s,on:l=>{s=l,r()}})]}function A1(n,{values:e,said:t}){let{tcMode:i,...s}=e;return[B("h3",{class:"apart",text:n}),t&&ei([{code:"it said",message:t}],"warn"),Hn(i!==void 0&&Qe("tcMode",Ya(i),"",T1(i,"tcShare"in e)),Object.entries(s).map(([r,o])=>Qe(Dh[r]?.[0]??r,r==="tcBucket"&&o===-1?"originals":Ya(o),r==="tcBucket"?"":Dh[r]?.[1],r)))]}function C1(n,e){let t=e.map(a=>a.t_s/60),i=Object.keys(e.at(-1).values).filter(a=>a!=="tcMode"&&e.some(l=>typeof l.values[a]=="number")),s=e.filter((a,l)=>l===0||["tcMode","tcBucket"].some(c=>a.values[c]!==e[l-1].values[c])||a.said!==e[l-1].said),r=[{key:"t",label:"minute of the watch",number:!0,value:a=>a.t_s,text:a=>(a.t_s/60).toFixed(2)},...Object.keys(e.at(-1).values).map(a=>({key:a,label:a,number:!0,value:l=>l.values[a],text:l=>Ya(l.values[a])})),{key:"said",label:"it said",value:a=>a.said??"",text:a=>a.said??"",class:"reason"}],o=e.length===1;return Ze(`course-${n.replace(/\W/g,"-")}`,`${n}: how it went`,n.split("/")[1],B("div",{class:"plots"},i.map(a=>Un({title:Dh[a]?.[0]??a,x:t,xLabel:"minutes of the watch",yLabel:Dh[a]?.[1]||a,height:210,zero:a!=="tcDegrees",text:`${a} from ${Ya(e[0].values[a])} to ${Ya(e.at(-1).values[a])}`,series:[{label:a,colour:"after",dots:o,values:e.map(l=>typeof l.values[a]=="number"?l.values[a]:null)}]}).element)),B("h3",{class:"apart",text:"Changes of mode, bucket and message"}),tn({caption:"Changes",name:"changes",columns:r,rows:[...s].reverse(),searchable:!1}).element,as("All looks",()=>tn({caption:"Looks",name:"looks",columns:r,rows:[...e].reverse(),searchable:!1}).element))}var R1={compensate:Z_,diagnose:r0,simulate:U0,fit:A0,accuracy:I0,"compare-measurements":L0,"closed-loop":D0,"link watch":O0},Za=JSON.parse(document.getElementById("data").textContent),ja=Za.view.tasks?Za.data.tasks:null,_d=ja&&Math.min(Math.max(Number(new URLSearchParams(location.search).get("task")??1)-1,0),ja.length-1)||0,Nh=ja?{...Za,data:ja[_d],view:Za.view.tasks[_d]}:Za,P1=R1[Nh.command]??T0,{kind:I1,verdict:L1,tone:D1,sections:N1}=P1(Nh),B0=B("main",{id:"main",tabIndex:-1}),k0=ig({title:Nh.title,kind:I1,verdict:L1,tone:D1,version:Nh.version,tasks:ja?.map(n=>n.task),which:_d});document.getElementById("page").replaceChildren(B("a",{class:"skip",href:"#main",text:"Skip to the contents"}),k0.element,B0);function z0(n){let[e,...t]=n;if(!e){document.documentElement.dataset.whole="yes",dispatchEvent(new Event("page-whole"));return}let i=e();i&&(B0.append(i),k0.link(i));let s=()=>z0(t);document.hidden?setTimeout(s):requestAnimationFrame(()=>setTimeout(s))}z0(N1);
